// world_parts_test.cpp - parts of worlds, against the whole world with all else collapsed to a point.
#include "cutouts.h"
#include "message_of.h"
#include "scenes.h"

#include <firsthit/error.h>
#include <firsthit/scene_builder.h>
#include <firsthit/world_parts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace firsthit {
namespace {

/// Random triangles in `count` instances, around the eye as well as before it; solid, cut out,
/// and blended.
std::shared_ptr<const Scene> parts_crowd(std::uint32_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> wide(-3.0f, 3.0f), small(-0.8f, 0.8f), unit(0.0f, 1.0f);
    SceneBuilder builder("crowd");
    Material material;
    material.name = "solid";
    material.opacity_texture.texture = 0; // of no use, as it is opaque
    builder.add_material(material);
    material.name = "holes";
    material.alpha = AlphaMode::mask;
    builder.add_material(material);
    material.opacity_texture.texture = 1;
    material.alpha = AlphaMode::blend;
    builder.add_material(material);
    builder.add_texture(test::alpha_texture(2, 2, {255, 0, 0, 255}));
    builder.add_texture(test::alpha_texture(2, 1, {0, 200}));
    builder.add_node({.name = "root"});
    for (std::uint32_t k = 0; k < count; ++k) {
        Mesh mesh;
        const glm::vec3 middle(wide(random), wide(random), wide(random));
        for (std::uint32_t t = 0; t < 5; ++t) {
            for (int corner = 0; corner < 3; ++corner) {
                mesh.position.push_back(
                    middle + glm::vec3(small(random), small(random), small(random)));
                mesh.normal.push_back(glm::vec3(0, 0, 1));
                mesh.color.push_back(glm::vec4(1, 1, 1, unit(random)));
                mesh.uv.push_back(glm::vec2(unit(random), unit(random)) * 3.0f);
            }
            mesh.index.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        builder.add_instance(builder.add_mesh(std::move(mesh)), 0, k % 3);
    }
    return std::make_shared<const Scene>(builder.build());
}

View parts_view()
{
    View view;
    view.width = 150;
    view.height = 90;
    view.camera.eye = {0.2, 0.1, 4};
    view.camera.direction = {-0.1, 0.05, -1};
    view.camera.fov_y_rad = 1.2;
    return view;
}

std::vector<std::uint32_t> parts_items(Renderer& renderer, const World& world, const View& view)
{
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    Film film;
    renderer.render(world, view, settings, film);
    return film.item;
}

/// The world with every vertex of other instances at one point, which no ray hits.
World world_with_only(const World& world, const std::vector<std::uint32_t>& instances)
{
    World result = world;
    for (std::size_t k = 0; k < world.scene->instances.size(); ++k) {
        if (std::find(instances.begin(), instances.end(), k) != instances.end()) continue;
        const Instance& other = world.scene->instances[k];
        std::fill_n(result.position.begin() + other.first_vertex, other.vertex_count, glm::vec3(0));
    }
    return result;
}

std::uint64_t pixels_seen(const std::vector<std::uint32_t>& items)
{
    return std::uint64_t(
        std::count_if(items.begin(), items.end(), [](auto item) { return item != kNoItem; }));
}

TEST(WorldParts, PixelsAloneAreThoseOfTheWorldWithAllElseCollapsed)
{
    Renderer renderer(2);
    std::uint64_t total = 0, behind = 0;
    for (const unsigned seed : {1u, 2u, 3u}) {
        World world;
        renderer.pose(parts_crowd(24, seed), 0.0, world);
        View view = parts_view();
        if (seed == 2) view.region = {31, 17, 70, 40};
        if (seed == 3) view.camera.eye = {0, 0, 0}; // triangles all around
        std::vector<std::vector<std::uint32_t>> parts;
        for (std::uint32_t k = 0; k < 24; ++k) parts.push_back({k});
        parts.push_back({});
        parts.push_back({3, 7, 20});
        parts.push_back({20, 3});
        const std::vector<std::uint64_t> counts = pixels_alone(renderer, world, view, parts);
        ASSERT_EQ(counts.size(), parts.size());
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const World collapsed = world_with_only(world, parts[k]);
            EXPECT_EQ(counts[k], pixels_seen(parts_items(renderer, collapsed, view)))
                << seed << ' ' << k;
            total += counts[k];
            behind += counts[k] == 0;
        }
    }
    EXPECT_GT(total, 3000u);
    EXPECT_GT(behind, 3u);
}

TEST(WorldParts, TrianglesKeepTheirOrderAndPlace)
{
    Renderer renderer(1);
    World world;
    renderer.pose(parts_crowd(9, 7), 0.0, world);
    WorldParts parts(world);
    const std::vector<std::uint32_t> chosen = {4, 0, 8};
    const World& part = parts.part(chosen);
    const std::vector<std::uint32_t> items = parts_items(renderer, part, parts_view());
    const std::vector<std::uint32_t> whole =
        parts_items(renderer, world_with_only(world, chosen), parts_view());
    ASSERT_GT(pixels_seen(items), 100u);
    for (std::size_t k = 0; k < items.size(); ++k) {
        ASSERT_EQ(items[k] == kNoItem, whole[k] == kNoItem);
        if (items[k] == kNoItem) continue;
        const std::uint32_t triangle = whole[k], instance = world.scene->owner[triangle];
        ASSERT_EQ(chosen[part.scene->owner[items[k]]], instance);
        ASSERT_EQ(triangle - world.scene->instances[instance].first_triangle, items[k] % 5);
    }
}

TEST(WorldParts, NoRayOutsideOfTheRegionMeetsTheWorld)
{
    Renderer renderer(2);
    const View view = parts_view();
    std::size_t smaller = 0;
    for (unsigned seed = 10; seed < 60; ++seed) {
        World world;
        renderer.pose(parts_crowd(1, seed), 0.0, world);
        const std::vector<std::uint32_t> items = parts_items(renderer, world, view);
        const std::optional<Region> region = region_that_sees(world, view);
        if (!region) {
            EXPECT_EQ(pixels_seen(items), 0u);
            continue;
        }
        smaller += region->width * region->height < view.width * view.height / 2;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const bool inside = x >= region->x && x < region->x + region->width &&
                                    y >= region->y && y < region->y + region->height;
                if (!inside) {
                    ASSERT_EQ(items[std::size_t(y * view.width + x)], kNoItem);
                }
            }
    }
    EXPECT_GT(smaller, 20u);
}

TEST(WorldParts, WrongNumbersAreRefused)
{
    Renderer renderer(1);
    World world;
    EXPECT_THROW(WorldParts{world}, ArgumentError);
    renderer.pose(parts_crowd(2, 1), 0.0, world);
    WorldParts parts(world);
    const std::vector<std::uint32_t> wrong = {2};
    EXPECT_EQ(message_of<ArgumentError>([&] { parts.part(wrong); }),
        "crowd: there is no instance 2: it has 2");
    View view = parts_view();
    view.width = 0;
    EXPECT_THROW((void)region_that_sees(world, view), ArgumentError);
}

} // namespace
} // namespace firsthit
