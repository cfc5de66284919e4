// builtin_wave.cpp - a cloth of any number of triangles, of which every vertex moves every frame.
//
// Its height is a sum of three travelling waves,
//     y = sum A sin(a x + b z + w t)
//       = sum sin(a x) A cos(b z + w t) + cos(a x) A sin(b z + w t),
// so that a vertex needs tables by column (made once), two numbers by row (made once a row and
// frame), and no sine of its own. The normal is (-dy/dx, 1, -dy/dz), made unit.
#include "samples/builtin.h"
#include "samples/wave_kernel.h"

#include <firsthit/error.h>
#include <firsthit/scene_builder.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace firsthit {
namespace {

constexpr double kSize = 2.0;    // the cloth's sides, around the origin
constexpr double kPeriod = 10.0; // s; all waves repeat after it

struct Wave {
    double amplitude;
    double a; // by x, 1 / unit
    double b; // by z
    double w; // by time, a whole multiple of 2 pi / kPeriod
};
constexpr double kTurn = 2 * std::numbers::pi / kPeriod;
constexpr std::array<Wave, 3> kWaves{{
    {0.085, 4.1, 1.3, 7 * kTurn},
    {0.045, -2.6, 6.3, 11 * kTurn},
    {0.018, 9.7, 7.9, -16 * kTurn},
}};
static_assert(kWaves.size() == kWaveCount);

struct Column {
    std::array<std::vector<float>, kWaves.size()> sine; // of a x, by column
    std::array<std::vector<float>, kWaves.size()> cosine;
    std::vector<float> x;
};

struct Grid {
    std::uint32_t columns; // of quads
    std::uint32_t rows;
};

Grid grid_for(std::uint64_t triangles)
{
    const std::uint64_t quads = (triangles + 1) / 2;
    auto columns = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(quads)));
    columns = std::max<std::uint64_t>(1, columns);
    const std::uint64_t rows = (quads + columns - 1) / columns;
    return {static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows)};
}

/// Place i of n + 1 along a side.
double place(std::size_t i, std::size_t n)
{
    return kSize * (static_cast<double>(i) / static_cast<double>(n) - 0.5);
}

Column make_columns(std::uint32_t columns)
{
    Column made;
    const std::size_t padded = std::size_t(columns) + 1 + kWavePadding;
    made.x.resize(padded);
    for (std::size_t c = 0; c < padded; ++c) made.x[c] = static_cast<float>(place(c, columns));
    for (std::size_t k = 0; k < kWaves.size(); ++k) {
        made.sine[k].resize(padded);
        made.cosine[k].resize(padded);
        for (std::size_t c = 0; c < padded; ++c) {
            made.sine[k][c] = static_cast<float>(std::sin(kWaves[k].a * place(c, columns)));
            made.cosine[k][c] = static_cast<float>(std::cos(kWaves[k].a * place(c, columns)));
        }
    }
    return made;
}

WaveRow make_row(double z, double time_s)
{
    WaveRow row;
    row.z = static_cast<float>(z);
    for (std::size_t k = 0; k < kWaves.size(); ++k) {
        const double angle = kWaves[k].b * z + kWaves[k].w * time_s;
        row.p[k] = static_cast<float>(kWaves[k].amplitude * std::cos(angle));
        row.q[k] = static_cast<float>(kWaves[k].amplitude * std::sin(angle));
        row.a[k] = static_cast<float>(kWaves[k].a);
        row.b[k] = static_cast<float>(kWaves[k].b);
    }
    return row;
}

Deform make_deform(Grid grid)
{
    // Shared, so that copies of the scene do not copy the tables.
    const auto table = std::make_shared<const Column>(make_columns(grid.columns));
    return [table, grid](double time_s, std::size_t first, std::size_t last, glm::vec3* position,
               glm::vec3* normal) {
        const std::size_t width = std::size_t(grid.columns) + 1;
        WaveColumns columns{.x = table->x.data(), .sine = {}, .cosine = {}};
        for (std::size_t k = 0; k < kWaves.size(); ++k) {
            columns.sine[k] = table->sine[k].data();
            columns.cosine[k] = table->cosine[k].data();
        }
        for (std::size_t v = first; v < last;) {
            const std::size_t column = v % width;
            const std::size_t count = std::min(last - v, width - column);
            const WaveRow row = make_row(place(v / width, grid.rows), time_s);
            fill_wave(columns, row, column, count, position, normal);
            v += count;
            position += count;
            normal += count;
        }
    };
}

} // namespace

Scene make_wave(std::uint64_t triangles)
{
    if (triangles < kMinWave || triangles > kMaxWave)
        throw ArgumentError(fmt::format("builtin:wave?n={}: n is the number of triangles, {} to {}",
            triangles, kMinWave, kMaxWave));
    const Grid grid = grid_for(triangles);

    Material material;
    material.name = "cloth";
    material.model = Phong{.ambient = {0.02f, 0.04f, 0.08f},
        .diffuse = {0.15f, 0.38f, 0.75f},
        .specular = glm::vec3(0.35f),
        .shininess = 25.0f};

    const std::uint32_t width = grid.columns + 1;
    Mesh mesh;
    mesh.index.reserve(std::size_t(grid.columns) * grid.rows * 2);
    for (std::uint32_t r = 0; r < grid.rows; ++r)
        for (std::uint32_t c = 0; c < grid.columns; ++c) {
            // z grows with the row, so that the front is up.
            const std::uint32_t a = r * width + c;
            mesh.index.emplace_back(a, a + width, a + width + 1);
            mesh.index.emplace_back(a, a + width + 1, a + 1);
        }
    mesh.vertices = std::size_t(width) * (grid.rows + 1);
    mesh.deform = make_deform(grid);

    SceneBuilder builder("wave");
    builder.add_instance(builder.add_mesh(std::move(mesh)), builder.add_node({.name = "cloth"}),
        builder.add_material(std::move(material)));
    Camera camera;
    camera.eye = {0, 2.55, 1.55};
    camera.direction = glm::dvec3(0, -0.02, 0.13) - camera.eye;
    camera.fov_y_rad = 0.81;
    builder.add_camera({.name = "camera", .camera = camera});
    builder.add_light({.position = {-2.5, 3.5, -1.5}});
    builder.set_background({0.02f, 0.03f, 0.05f});
    builder.add_clip({.name = "wave", .end_s = kPeriod, .frames = 301}); // 30 a second
    return builder.build();
}

} // namespace firsthit
