// unit_of_3mf_test.cpp - lengths of 3MF files become metres, whatever their unit is.
#include "readers/assimp/read_assimp.h"
#include "readers/assimp/unit_of_3mf.h"
#include "readers/assimp/zip_text.h"
#include "readers/scene_parts.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

namespace firsthit::test {
namespace {

glm::vec3 size_of(Scene scene)
{
    World world;
    pose(std::move(scene), 0, world);
    return bounds(world)[1] - bounds(world)[0];
}

Scene read_3mf(const std::string& bytes)
{
    return read_assimp("m.3mf", bytes, ".3mf", {}, {});
}

TEST(UnitOf3mf, IsReadFromPartsThatArePackedOrNot)
{
    for (const bool is_packed : {false, true}) {
        EXPECT_EQ(unit_of_3mf(triangle_3mf(R"(unit="inch")", is_packed)), "inch");
        EXPECT_EQ(unit_of_3mf(triangle_3mf(R"(xml:lang="en" unit = 'foot')", is_packed)), "foot");
        EXPECT_EQ(unit_of_3mf(triangle_3mf(R"(xml:lang="en")", is_packed)), "");
        EXPECT_EQ(unit_of_3mf(triangle_3mf(R"(my:unit="inch" subunit="foot")", is_packed)), "");
    }
}

TEST(UnitOf3mf, IsEmptyWhereTheArchiveIsDamaged)
{
    const std::string bytes = triangle_3mf(R"(unit="inch")", true);
    EXPECT_EQ(unit_of_3mf(""), "");
    EXPECT_EQ(unit_of_3mf("PK\5\6"), "");
    // The last two bytes are the length of a comment.
    for (std::size_t n = 0; n + 2 < bytes.size(); ++n)
        EXPECT_EQ(unit_of_3mf(std::string_view(bytes).substr(0, n)), "") << n;
    // Any byte may be another one: nothing reads beyond the end.
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        std::string damaged = bytes;
        damaged[n] = '\xFF';
        EXPECT_LE(unit_of_3mf(damaged).size(), bytes.size());
    }
}

TEST(UnitOf3mf, LengthsBecomeMetres)
{
    const auto units =
        std::to_array<std::pair<const char*, double>>({{"micron", 1e-6}, {"millimeter", 1e-3},
            {"centimeter", 1e-2}, {"inch", 0.0254}, {"foot", 0.3048}, {"meter", 1.0}});
    for (const auto& [unit, metres] : units) {
        SCOPED_TRACE(unit);
        const Scene scene = read_3mf(triangle_3mf(std::string("unit=\"") + unit + '"', true));
        EXPECT_TRUE(scene.warnings.empty());
        const glm::vec3 size = size_of(scene); // z of the file is y
        EXPECT_NEAR(size.x, 2 * metres, 1e-6 * metres);
        EXPECT_NEAR(size.y, metres, 1e-6 * metres);
        EXPECT_EQ(size.z, 0);
    }
}

TEST(UnitOf3mf, IsAMillimetreWhereTheFileSaysNoneOrNoneThatIsKnown)
{
    const Scene none = read_3mf(triangle_3mf("", false));
    EXPECT_TRUE(none.warnings.empty());
    EXPECT_NEAR(size_of(none).x, 2e-3, 1e-9);
    const Scene unknown = read_3mf(triangle_3mf(R"(unit="furlong")", false));
    EXPECT_EQ(
        warning_of(unknown), "m.3mf: the unit 'furlong' is none of 3MF's; millimetres are taken");
    EXPECT_NEAR(size_of(unknown).x, 2e-3, 1e-9);
}

} // namespace
} // namespace firsthit::test
