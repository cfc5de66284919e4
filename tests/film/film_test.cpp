// film_test.cpp - the names of planes.
#include "message_of.h"

#include <firsthit/error.h>
#include <firsthit/film.h>

#include <gtest/gtest.h>

namespace firsthit {
namespace {

TEST(Film, EveryPlanesNameIsFoundAgain)
{
    for (int a = 0; a < kAovCount; ++a) {
        const Aov aov = static_cast<Aov>(a);
        EXPECT_EQ(aov_from_name(aov_name(aov)), aov);
    }
}

TEST(Film, PlanesHaveTheDocumentedChannels)
{
    EXPECT_EQ(aov_channels(Aov::item), 1);
    EXPECT_EQ(aov_channels(Aov::uv), 2);
    EXPECT_EQ(aov_channels(Aov::albedo), 3);
    EXPECT_EQ(aov_channels(Aov::lit), 0) << "as many as there are lights";
}

TEST(Film, AnUnknownNameIsAnErrorThatListsTheNames)
{
    EXPECT_EQ(message_of<ArgumentError>([] { aov_from_name("colour"); }),
        "unknown plane 'colour': accepted are item, depth, distance, uv, "
        "normal, geometric_normal, position, albedo, barycentric, lit, instance, material, node, "
        "tangent, metallic_roughness, emission, motion, motion_visible, normal_camera, "
        "position_camera");
}

} // namespace
} // namespace firsthit
