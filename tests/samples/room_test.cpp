// room_test.cpp - the built-in room: counts, lights, closed solids, the same bits, and a car that rolls.
#include "samples/builtin.h"
#include "samples/trigonometry.h"
#include "scene/model/check_scene.h"

#include <firsthit/world.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace firsthit {
namespace {

const std::shared_ptr<const Scene>& room()
{
    static const auto scene = std::make_shared<const Scene>(make_room());
    return scene;
}

World room_at(double time_s)
{
    World world;
    pose(room(), time_s, world);
    return world;
}

const std::string& node_name(const Instance& instance)
{
    return room()->nodes[instance.node].name;
}

/// FNV-1a over 32-bit words.
class WordHash {
  public:
    void add(std::uint32_t word)
    {
        for (int byte = 0; byte < 4; ++byte) {
            value_ ^= (word >> (8 * byte)) & 0xFFu;
            value_ *= 0x100000001B3u;
        }
    }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
    void add(double value)
    {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        add(static_cast<std::uint32_t>(bits));
        add(static_cast<std::uint32_t>(bits >> 32));
    }
    void add(const glm::vec3& v)
    {
        for (int k = 0; k < 3; ++k) add(v[k]);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xCBF29CE484222325u;
};

TEST(SineCosine, IsThatOfTheLibraryToAFewUnitsInTheLastPlace)
{
    for (int k = -200'000; k <= 200'000; ++k) {
        const double angle = 0.00371 * k;
        const auto [s, c] = sine_cosine(angle);
        ASSERT_NEAR(s, std::sin(angle), 1e-15) << angle;
        ASSERT_NEAR(c, std::cos(angle), 1e-15) << angle;
    }
    EXPECT_EQ(sine(0), 0);
    EXPECT_EQ(cosine(0), 1);
}

TEST(BuiltinRoom, HasTheCountsItPromises)
{
    const Scene& scene = *room();
    EXPECT_GE(scene.triangle_count(), 80'000u);
    EXPECT_LE(scene.triangle_count(), 120'000u);
    EXPECT_EQ(scene.begin_s(), 0.0);
    EXPECT_EQ(scene.end_s(), 20.0);
    EXPECT_GE(scene.cameras.at(0).node, 0);
    EXPECT_GE(scene.textures.size(), 10u);
    EXPECT_NO_THROW(check_scene(scene));

    std::map<Light::Kind, int> lights;
    for (const Light& light : scene.lights) ++lights[light.kind];
    EXPECT_EQ(lights[Light::Kind::point], 6);
    EXPECT_EQ(lights[Light::Kind::directional], 1);
    EXPECT_EQ(scene.lights.size(), 7u);
}

TEST(BuiltinRoom, KeepsWhatMirrorsAndGlassNeed)
{
    std::map<std::string, Phong> phong;
    for (const Material& material : room()->materials)
        phong[material.name] = std::get<Phong>(material.model);
    EXPECT_GE(phong.at("mirror").specular.x, 0.8f);
    EXPECT_GE(phong.at("chrome").specular.x, 0.7f);
    EXPECT_GE(phong.at("glass").transmittance, 0.8f);
    EXPECT_EQ(phong.at("glass").ior, 1.5f);
}

TEST(BuiltinRoom, HasTheSameBitsOnEveryMachine)
{
    const Scene& scene = *room();
    WordHash arrays, keys, texels;
    for (const glm::vec3& p : scene.position) arrays.add(p);
    for (const glm::vec3& n : scene.normal) arrays.add(n);
    for (const glm::vec2& uv : scene.uv) {
        arrays.add(uv.x);
        arrays.add(uv.y);
    }
    for (const glm::uvec3& t : scene.index)
        for (int k = 0; k < 3; ++k) arrays.add(t[k]);
    for (const Channel& channel : scene.clips.at(0).channels)
        for (const double value : channel.value) keys.add(value);
    for (const Node& node : scene.nodes)
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) keys.add(node.local[column][row]);
    for (const Texture& texture : scene.textures)
        for (const Texel& texel : texture.texels())
            for (const std::int16_t value : texel)
                texels.add(static_cast<std::uint32_t>(static_cast<std::uint16_t>(value)));
    EXPECT_EQ(arrays.value(), 7291841352152574825u);
    EXPECT_EQ(keys.value(), 6078165397896007229u);
    EXPECT_EQ(texels.value(), 10193384160932834305u);

    WordHash posed;
    for (const double time_s : {0.0, 3.33, 12.5, 20.0})
        for (const glm::vec3& p : room_at(time_s).position) posed.add(p);
    EXPECT_EQ(posed.value(), 10119115942985771290u);
}

TEST(BuiltinRoom, TrianglesFaceTheWayOfTheirNormals)
{
    const Scene& scene = *room();
    for (const glm::vec3& n : scene.normal) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
    for (std::size_t t = 0; t < scene.triangle_count(); ++t) {
        const glm::uvec3 corner = scene.index[t];
        const glm::dvec3 a(scene.position[corner.x]);
        const glm::dvec3 face = glm::cross(
            glm::dvec3(scene.position[corner.y]) - a, glm::dvec3(scene.position[corner.z]) - a);
        const glm::dvec3 sum(
            scene.normal[corner.x] + scene.normal[corner.y] + scene.normal[corner.z]);
        ASSERT_GT(glm::length(face), 0.0);
        ASSERT_GT(glm::dot(face, sum), 0.0) << node_name(scene.instances[scene.owner[t]]);
    }
}

/// Edges of an instance that no triangle passes the other way, corners counted as one by their places.
std::size_t open_edges(const Instance& instance)
{
    using Place = std::tuple<float, float, float>;
    const Scene& scene = *room();
    std::map<Place, std::uint32_t> number;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto corner = [&](std::uint32_t vertex) {
        const glm::vec3& p = scene.position[vertex];
        return number.try_emplace({p.x, p.y, p.z}, number.size()).first->second;
    };
    for (std::uint32_t t = 0; t < instance.triangle_count; ++t) {
        const glm::uvec3 index = scene.index[instance.first_triangle + t];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = corner(index[k]), b = corner(index[(k + 1) % 3]);
            a < b ? ++edges[{a, b}] : --edges[{b, a}];
        }
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
}

TEST(BuiltinRoom, IsMadeOfClosedSolidsAndOfSheets)
{
    const std::set<std::string> sheets{"curtain", "leaves", "pane"};
    std::set<std::string> seen;
    for (const Instance& instance : room()->instances) {
        const std::string& name = node_name(instance);
        if (sheets.contains(name)) {
            EXPECT_GT(open_edges(instance), 0u) << name;
            seen.insert(name);
        } else {
            EXPECT_EQ(open_edges(instance), 0u) << name;
        }
    }
    EXPECT_EQ(seen, sheets);
}

/// The instances of nodes of a name.
std::vector<const Instance*> instances_named(const std::string& name)
{
    std::vector<const Instance*> found;
    for (const Instance& instance : room()->instances)
        if (node_name(instance) == name) found.push_back(&instance);
    return found;
}

glm::dvec3 middle_of(const World& world, const Instance& instance)
{
    glm::dvec3 sum(0);
    for (std::uint32_t v = 0; v < instance.vertex_count; ++v)
        sum += glm::dvec3(world.position[instance.first_vertex + v]);
    return sum / static_cast<double>(instance.vertex_count);
}

TEST(BuiltinRoom, OnlyTheCarMoves)
{
    const World a = room_at(4.0), b = room_at(4.1);
    for (const Instance& instance : room()->instances) {
        const bool car = node_name(instance) == "body" || node_name(instance) == "wheel";
        bool moved = false;
        for (std::uint32_t v = instance.first_vertex;
             v < instance.first_vertex + instance.vertex_count; ++v)
            moved = moved || a.position[v] != b.position[v];
        EXPECT_EQ(moved, car) << node_name(instance);
    }
    EXPECT_NE(a.camera.eye, b.camera.eye);
}

TEST(BuiltinRoom, WheelsRollWithoutSliding)
{
    constexpr double kStep = 0.004;
    for (const double time_s : {0.5, 6.1, 13.7, 18.9}) {
        const World a = room_at(time_s), b = room_at(time_s + kStep);
        const std::vector<const Instance*> wheels = instances_named("wheel");
        ASSERT_EQ(wheels.size(), 8u); // a tyre and a hub each
        for (std::size_t k = 0; k < wheels.size(); k += 2) {
            const Instance& tyre = *wheels[k];
            const double way = glm::length(middle_of(b, tyre) - middle_of(a, tyre));
            EXPECT_GT(way, 0.2 * kStep); // m/s
            // What touches the floor rests on it; what is on top is twice as fast as the axle.
            std::uint32_t low = tyre.first_vertex, high = low;
            for (std::uint32_t v = low; v < tyre.first_vertex + tyre.vertex_count; ++v) {
                if (a.position[v].y < a.position[low].y) low = v;
                if (a.position[v].y > a.position[high].y) high = v;
            }
            EXPECT_NEAR(a.position[low].y, 0.0, 1e-3);
            const auto moved = [&](std::uint32_t v) {
                return double(glm::length(b.position[v] - a.position[v]));
            };
            EXPECT_LT(moved(low), 0.25 * way) << time_s;
            EXPECT_NEAR(moved(high), 2 * way, 0.25 * way) << time_s;
        }
    }
}

TEST(BuiltinRoom, TheCarDrivesOnceAroundTheTableAndMeetsNothing)
{
    const std::vector<const Instance*> bodies = instances_named("body");
    ASSERT_FALSE(bodies.empty());
    const glm::dvec3 start = middle_of(room_at(0), *bodies[0]);
    EXPECT_LT(glm::length(middle_of(room_at(20), *bodies[0]) - start), 1e-3);
    EXPECT_GT(glm::length(middle_of(room_at(10), *bodies[0]) - start), 2.0);

    for (double time_s = 0; time_s <= 20; time_s += 0.25) {
        const World world = room_at(time_s);
        glm::vec3 low(1e9f), high(-1e9f);
        for (const Instance* body : bodies)
            for (std::uint32_t v = 0; v < body->vertex_count; ++v) {
                low = glm::min(low, world.position[body->first_vertex + v]);
                high = glm::max(high, world.position[body->first_vertex + v]);
            }
        for (const Instance& instance : room()->instances) {
            if (node_name(instance) == "body" || node_name(instance) == "wheel") continue;
            for (std::uint32_t v = 0; v < instance.vertex_count; ++v) {
                const glm::vec3& p = world.position[instance.first_vertex + v];
                ASSERT_FALSE(glm::all(glm::greaterThan(p, low)) && glm::all(glm::lessThan(p, high)))
                    << node_name(instance) << " at " << time_s << " s";
            }
        }
    }
}

TEST(BuiltinRoom, TheCameraStaysInside)
{
    for (double time_s = 0; time_s <= 20; time_s += 0.1) {
        const glm::dvec3 eye = room_at(time_s).camera.eye;
        EXPECT_LT(std::abs(eye.x), 2.8);
        EXPECT_GT(eye.y, 1.0);
        EXPECT_LT(eye.y, 1.8);
        EXPECT_LT(std::abs(eye.z), 2.4);
    }
}

} // namespace
} // namespace firsthit
