// nff_test.cpp - NFF files as programs write them: what is shown, what is left out, what is refused.
#include "readers/aff/aff_text.h"
#include "readers/scene_parts.h"

#include "message_of.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <variant>

namespace firsthit::test {
namespace {

const std::string kNumbered = "main.aff: ";

TEST(Nff, LeavesOutSpareNumbersOfMaterials)
{
    const Scene scene = scene_of(
        "f 1 0 0 0.8 0.2 30 0 1 0.2\n" + kTriangle + "f 0 1 0 0.8 0.2 30 0 1 0.2 5\n" + kTriangle);
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(std::get<Phong>(scene.materials[0].model).diffuse, glm::vec3(0.8f, 0, 0));
    EXPECT_EQ(warning_of(scene),
        kNumbered + "spare numbers of materials are left out (first at line 1, 3 times)");
}

TEST(Nff, LeavesOutPolygonsThatCannotBeShown)
{
    const Scene scene = scene_of("p 2\n0 0 0\n1 0 0\np 1\n0 0 0\n" + kTriangle);
    EXPECT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(warning_of(scene), kNumbered + "polygons with fewer than 3 corners are left out "
                                             "(first at line 3, 2 times)");
    for (const char* word : {"nan", "-nan(ind)", "inf", "1e40"}) {
        const Scene rest =
            scene_of("p 3\n0 0 0\n1 0 " + std::string(word) + "\n0 1 0\n" + kTriangle);
        EXPECT_EQ(rest.triangle_count(), 1u) << word;
        EXPECT_NE(
            warning_of(rest).find("polygons with a corner that is no finite float are left out"),
            std::string::npos)
            << word;
    }
    const Scene normals = scene_of("pp 3 0 0 0 nan 0 0 1 0 0 0 0 1 0 1 0 0 0 1");
    EXPECT_EQ(normals.triangle_count(), 1u);
    for (const glm::vec3& normal : normals.normal) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Nff, SolidsMayHaveARadiusForEachAxis)
{
    const Scene round = scene_of("oct 1 0 0 2\n"), flat = scene_of("oct 1 0 0 2 4 0.5\n");
    EXPECT_TRUE(flat.warnings.empty());
    ASSERT_EQ(flat.triangle_count(), 8u);
    for (std::size_t v = 0; v < flat.vertex_count(); ++v)
        EXPECT_LT(glm::distance(flat.position[v] - glm::vec3(1, 0, 0),
                      (round.position[v] - glm::vec3(1, 0, 0)) * glm::vec3(1, 2, 0.25f)),
            1e-6f);
    for (const glm::uvec3& t : flat.index) {
        const glm::vec3 cross = glm::cross(
            flat.position[t.y] - flat.position[t.x], flat.position[t.z] - flat.position[t.x]);
        EXPECT_LT(glm::distance(flat.normal[t.x], glm::normalize(cross)), 1e-5f);
    }
    EXPECT_EQ(scene_of("oct 0 0 0 1 2\n" + kTriangle).triangle_count(), 9u);

    // (x / 2)^2 + y^2 + (z / 4)^2 = 1, whose normals are its gradient.
    const Scene egg = scene_of("s 0 0 1 2 1 4\n");
    for (std::size_t v = 0; v < egg.vertex_count(); ++v) {
        const glm::vec3 p = egg.position[v] - glm::vec3(0, 0, 1);
        EXPECT_NEAR(p.x * p.x / 4 + p.y * p.y + p.z * p.z / 16, 1, 1e-5f);
        const glm::vec3 gradient(p.x / 4, p.y, p.z / 16);
        EXPECT_LT(glm::distance(egg.normal[v], glm::normalize(gradient)), 1e-5f);
    }
    EXPECT_EQ(scene_of("s 0 0 1 2 2 2\n").position, scene_of("s 0 0 1 2\n").position);
}

TEST(Nff, TakesMissingNumbersOfMaterialsForThoseOfAMattOne)
{
    const Scene scene = scene_of("f 0 0.5 1\n" + kTriangle + "f 1 1 1 0.5 0.25 8\n" + kTriangle);
    EXPECT_EQ(scene.triangle_count(), 2u);
    ASSERT_EQ(scene.materials.size(), 2u);
    const auto& plain = std::get<Phong>(scene.materials[0].model);
    EXPECT_EQ(plain.diffuse, glm::vec3(0, 0.5f, 1));
    EXPECT_EQ(plain.specular, glm::vec3(0));
    const auto& shiny = std::get<Phong>(scene.materials[1].model);
    EXPECT_EQ(shiny.diffuse, glm::vec3(0.5f));
    EXPECT_EQ(shiny.specular, glm::vec3(0.25f));
    EXPECT_EQ(shiny.shininess, 8);
    EXPECT_EQ(shiny.ior, 1);
    EXPECT_EQ(warning_of(scene), kNumbered + "missing numbers of materials are those of a matt one "
                                             "(first at line 1, 7 times)");
}

TEST(Nff, LeavesOutTexturesOfMaterials)
{
    const Scene scene = scene_of("f 1 0 0 0.8 0.2 30 0 1 earth.jpg\n" + kTriangle);
    EXPECT_EQ(
        warning_of(scene), kNumbered + "textures of materials are left out (first at line 1)");
    // A statement may follow on the line.
    EXPECT_TRUE(scene_of("f 1 0 0 0.8 0.2 30 0 1 " + kTriangle).warnings.empty());
}

TEST(Nff, LeavesOutSpareNumbersOfCorners)
{
    // A colour behind every corner and its normal: nine numbers.
    const std::string text =
        "pp 3\n0 0 0 0 0 1 1 0 0\n1 0 0 0 0 1 0 1 0\n0 1 0 0 1 0 0 0 1\n" + kTriangle;
    const Scene scene = scene_of(text);
    ASSERT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(corner(scene, 0, 1), glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.normal[scene.index[0].z], glm::vec3(0, 1, 0));
    EXPECT_EQ(
        warning_of(scene), kNumbered + "spare numbers of corners are left out (first at line 4)");
    EXPECT_EQ(corner(scene_of("p 3\n0 0 0 7 8\n1 0 0 7 8\n0 1 0 7 8\n"), 0, 2), glm::vec3(0, 1, 0));
    // A corner too many is no spare number.
    EXPECT_EQ(message_of<FileError>([] { scene_of("p 3\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"); }),
        "main.aff:5: there is no statement '1'");
}

TEST(Nff, WarnsOncePerFileOfStatementsThatNobodyKnows)
{
    const Scene scene = scene_of(kTriangle + "tess 4\nsides 3 # p 3\ntess 5\n" + kTriangle);
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(warning_of(scene), kNumbered +
                                     "statements that nobody knows are left out with the rest of "
                                     "their lines (first at 'tess' in line 2, 3 times)");
}

TEST(Nff, AsksForItsResolution)
{
    const std::string view = "v from 0 0 8 at 0 0 0 up 0 1 0 angle 40 hither 1 resolution ";
    EXPECT_EQ(scene_of(view + "640 480\n" + kTriangle).picture_size, glm::ivec2(640, 480));
    EXPECT_EQ(scene_of(kTriangle).picture_size, glm::ivec2(0));
    for (const char* const other : {"0 480", "640.5 480", "1e9 1e9"}) {
        const Scene scene = scene_of(view + other + "\n" + kTriangle);
        EXPECT_EQ(scene.picture_size, glm::ivec2(0));
        EXPECT_EQ(warning_of(scene), kNumbered +
                                         "a resolution other than whole numbers of 1 to 65536 is "
                                         "left out (first at line 1)");
    }
}

TEST(Nff, MakesSolidsOfExtendedNff)
{
    const struct {
        const char* name;
        std::size_t triangles, corners, faces;
    } solids[] = {{"tet", 4, 4, 4}, {"hex", 12, 8, 6}, {"oct", 8, 6, 8}, {"dod", 36, 20, 12}};
    for (const auto& solid : solids) {
        const Scene scene = scene_of(std::string(solid.name) + " 1 2 3 2\n");
        EXPECT_EQ(scene.triangle_count(), solid.triangles) << solid.name;
        EXPECT_TRUE(scene.warnings.empty());
        // Closed, turned outwards, with corners at the radius.
        double volume = 0;
        for (std::size_t t = 0; t < scene.triangle_count(); ++t) {
            glm::dvec3 p[3];
            for (int k = 0; k < 3; ++k) {
                p[k] = glm::dvec3(corner(scene, t, k)) - glm::dvec3(1, 2, 3);
                EXPECT_NEAR(glm::length(p[k]), 2, 1e-6);
                EXPECT_GT(glm::dot(p[k], glm::dvec3(scene.normal[scene.index[t][k]])), 0);
            }
            volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
        }
        const double unit = solid.faces == 4     ? 8 * std::sqrt(3) / 27
                            : solid.corners == 8 ? 8 * std::sqrt(3) / 9
                            : solid.faces == 8   ? 4.0 / 3
                                                 : 2.785163863;
        EXPECT_NEAR(volume, 8 * unit, 1e-5) << solid.name;
    }
}

TEST(Nff, RefusesNumbersWhereAStatementShouldStand)
{
    EXPECT_EQ(message_of<FileError>([] { scene_of(kTriangle + "1 2 3\n"); }),
        "main.aff:2: there is no statement '1'");
}

TEST(Nff, RefusesTheNffOfWorldToolKit)
{
    const std::string message =
        message_of<FileError>([] { scene_of("nff\nversion 2.0\nviewpos 0 0 0\n"); });
    EXPECT_EQ(message,
        "main.aff:1: this is NFF of WorldToolKit, another format of that name; Haines's Neutral "
        "File Format is read");
}

TEST(Nff, CutsConcavePolygonsIntoTheirOwnArea)
{
    const Scene scene = scene_of("p 6  2 0 0  2 1 0  1 1 0  1 2 0  0 2 0  0 0 0\n");
    ASSERT_EQ(scene.triangle_count(), 4u);
    double area = 0;
    for (std::size_t t = 0; t < 4; ++t)
        area += 0.5 * glm::length(glm::cross(corner(scene, t, 1) - corner(scene, t, 0),
                          corner(scene, t, 2) - corner(scene, t, 0)));
    EXPECT_EQ(area, 3);
}

} // namespace
} // namespace firsthit::test
