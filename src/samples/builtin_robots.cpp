// builtin_robots.cpp - ten walking robots on a square.
#include "samples/builtin.h"
#include "samples/robots/robot.h"
#include "samples/robots/robot_scene.h"
#include "samples/shapes.h"
#include "samples/robots/tile_texture.h"
#include "samples/robots/walk.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

constexpr double kEnd = 10.0;        // s
constexpr double kGround = 160.0;    // m from the middle to the ground's edge
constexpr int kGroundQuads = 12;     // on a side
constexpr double kTextureSize = 4.0; // m that the texture covers once
constexpr double kWall = 9.5;        // m from the middle to the walls

Material material(const char* name, const Phong& model)
{
    Material made;
    made.name = name;
    made.model = model;
    return made;
}

Phong paint(const glm::vec3& color, float specular, float shininess)
{
    return {.ambient = 0.22f * color,
        .diffuse = color,
        .specular = glm::vec3(specular),
        .shininess = shininess};
}

Material painted(const char* name, const glm::vec3& color, float specular, float shininess)
{
    return material(name, paint(color, specular, shininess));
}

/// A lamp's surface: bright also where no light reaches it.
Material glowing(const char* name, Phong model, const glm::vec3& color)
{
    model.ambient = color;
    return material(name, model);
}

void add_ground(RobotScene& scene, std::int32_t node)
{
    scene.builder().add_texture(make_tiles());
    Phong tiles = paint(glm::vec3(1), 0.08f, 12);
    tiles.texture = 0;

    Shape ground;
    std::vector<glm::vec2> uv;
    for (int r = 0; r <= kGroundQuads; ++r)
        for (int c = 0; c <= kGroundQuads; ++c) {
            const double x = kGround * (2.0 * c / kGroundQuads - 1);
            const double z = kGround * (2.0 * r / kGroundQuads - 1);
            ground.position.emplace_back(x, 0, z);
            ground.normal.emplace_back(0, 1, 0);
            uv.emplace_back(x / kTextureSize, z / kTextureSize);
        }
    constexpr std::uint32_t kWidth = kGroundQuads + 1;
    for (std::uint32_t r = 0; r < kGroundQuads; ++r)
        for (std::uint32_t c = 0; c < kGroundQuads; ++c) {
            const std::uint32_t a = r * kWidth + c;
            ground.index.emplace_back(a, a + kWidth, a + kWidth + 1);
            ground.index.emplace_back(a, a + kWidth + 1, a + 1);
        }
    scene.add_shape(node, scene.builder().add_material(material("tiles", tiles)), std::move(ground),
        std::move(uv));
}

/// A column with a lamp in the middle, low walls and bollards around.
void add_props(RobotScene& scene, std::int32_t node)
{
    const std::uint32_t stone =
        scene.builder().add_material(painted("stone", {0.52f, 0.50f, 0.46f}, 0.1f, 10));
    const std::uint32_t lamp = scene.builder().add_material(
        glowing("lamp", paint({0.9f, 0.8f, 0.5f}, 0.3f, 20), {0.95f, 0.80f, 0.45f}));

    Shape column;
    add_lathe(column,
        std::to_array<Outline>({{0, 2.3}, {0.30, 2.3}, {0.30, 2.3}, {0.34, 2.26}, {0.34, 2.16},
            {0.30, 2.12}, {0.22, 2.05}, {0.20, 1.9}, {0.23, 0.75}, {0.30, 0.62}, {0.40, 0.58},
            {0.42, 0.54}, {0.42, 0.34}, {0.42, 0.34}, {0.78, 0.34}, {0.80, 0.32}, {0.80, 0.17},
            {0.80, 0.17}, {1.15, 0.17}, {1.17, 0.15}, {1.17, 0.0}}),
        24);
    for (int side = 0; side < 8; ++side) {
        // A gap in the middle of every second side.
        const double angle = std::numbers::pi / 4 * side;
        const glm::dmat4 turn = moved(0, 0, 0, {0, 1, 0}, angle);
        if (side % 2 == 0) {
            for (const double end : {-1.0, 1.0})
                add_lathe(column,
                    std::to_array<Outline>({{0, 1.0}, {0.10, 0.98}, {0.16, 0.90}, {0.17, 0.82},
                        {0.13, 0.74}, {0.13, 0.12}, {0.20, 0.06}, {0.20, 0.0}}),
                    10, turn * moved(end * 2.4, 0, kWall));
        } else {
            add_rounded_box(column, {3.0, 0.35, 0.22}, 0.07, 1, turn * moved(0, 0.30, kWall));
            add_rounded_box(column, {3.12, 0.06, 0.30}, 0.03, 1, turn * moved(0, 0.70, kWall));
        }
    }
    scene.add_shape(node, stone, std::move(column));

    Shape light;
    add_ellipsoid(light, {0.30, 0.30, 0.30}, 20, moved(0, 2.58, 0));
    scene.add_shape(node, lamp, std::move(light));
}

void add_robots(RobotScene& scene)
{
    RobotPaint colors;
    colors.metal = scene.builder().add_material(painted("metal", {0.46f, 0.48f, 0.52f}, 0.55f, 35));
    colors.rubber =
        scene.builder().add_material(painted("rubber", {0.055f, 0.058f, 0.065f}, 0.25f, 18));
    colors.glow = scene.builder().add_material(
        glowing("glow", paint({0.3f, 0.8f, 0.9f}, 0.4f, 30), {0.35f, 0.95f, 1.0f}));

    // Linear colours, neighbours far apart.
    constexpr std::array<glm::vec3, 10> kColors{
        {{0.75f, 0.06f, 0.05f}, {0.06f, 0.24f, 0.70f}, {0.85f, 0.52f, 0.04f}, {0.07f, 0.45f, 0.13f},
            {0.80f, 0.80f, 0.76f}, {0.42f, 0.09f, 0.50f}, {0.82f, 0.24f, 0.03f},
            {0.03f, 0.46f, 0.46f}, {0.72f, 0.16f, 0.32f}, {0.30f, 0.42f, 0.06f}}};
    constexpr std::array<double, 10> kSizes{
        1.0, 0.82, 1.12, 0.94, 1.0, 1.06, 0.88, 1.15, 0.97, 0.78};

    // Four go around the column, six the other way outside.
    for (std::size_t r = 0; r < kColors.size(); ++r) {
        const bool inside = r < 4;
        Walk walk;
        walk.size = kSizes[r];
        walk.radius = inside ? 2.7 : 5.4;
        walk.direction = inside ? 1 : -1;
        // The same speed over ground for all of a ring: nobody catches up.
        walk.speed = (inside ? 0.80 : 0.92) / walk.size;
        walk.step_s = 1.1 * std::sqrt(walk.size);
        const double place = inside ? static_cast<double>(r) / 4 : static_cast<double>(r - 4) / 6;
        walk.start_rad = 2 * std::numbers::pi * place + 0.35;
        walk.phase = 0.37 * static_cast<double>(r);
        walk.waves = r == 2 || r == 8;
        const std::string name = "robot " + std::to_string(r + 1);
        colors.body =
            scene.builder().add_material(painted((name + " paint").c_str(), kColors[r], 0.5f, 40));
        add_robot(scene, name, colors, walk, 0, kEnd);
    }
}

/// From high outside down to the robots' eyes, a third of a turn around.
Placement camera_at(double time_s)
{
    const double u = time_s / kEnd;
    const double angle = 0.9 + 1.9 * u;
    const double distance = 10.6 - 2.4 * u;
    const glm::dvec3 target(0, 1.0 - 0.1 * u, 0);
    Placement camera;
    camera.position = {distance * std::sin(angle), 4.6 - 2.6 * u, distance * std::cos(angle)};
    const glm::dvec3 back = glm::normalize(camera.position - target);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
    camera.turn = glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
    return camera;
}

} // namespace

Scene make_robots()
{
    RobotScene scene("robots", kEnd, 301); // 30 frames a second
    const std::int32_t square = scene.add_node("square", -1, glm::dmat4(1));
    add_ground(scene, square);
    add_props(scene, square);
    add_robots(scene);

    SceneBuilder& builder = scene.builder();
    const std::int32_t way =
        scene.add_node("camera", -1, sample_track("camera", 0, kEnd, 0.5, camera_at));
    builder.add_camera(
        {.name = "camera", .camera = {.eye = {0, 0, 0}, .fov_y_rad = 0.70}, .node = way});
    builder.add_light({.position = {9, 16, 7}, .color = glm::vec3(0.80f, 0.76f, 0.68f)});
    builder.add_light({.position = {-14, 9, -6}, .color = glm::vec3(0.18f, 0.22f, 0.30f)});
    builder.set_background({0.30f, 0.45f, 0.66f});
    return scene.build();
}

} // namespace firsthit
