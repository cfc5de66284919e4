// world_parts.cpp - parts of a posed world, each as a world of its own.
#include "exact/pencil.h"
#include "render/check_settings.h"

#include <firsthit/error.h>
#include <firsthit/world_parts.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace firsthit {
namespace {

/// Vertices nearer to the plane of the eye than this are not projected.
constexpr double kNearestProjected = 1e-30;

/// Pixels by which rounding to float may move what was projected, and more.
constexpr double kPixelMargin = 2;

/// Appends values [first, first + count) of an array that may be empty.
template <class T>
void append_range(
    std::vector<T>& to, const std::vector<T>& from, std::size_t first, std::size_t count)
{
    if (from.empty()) return;
    const auto begin = from.begin() + std::ptrdiff_t(first);
    to.insert(to.end(), begin, begin + std::ptrdiff_t(count));
}

/// The textures that say where surfaces are; white ones in the place of the others.
std::vector<Texture> opacity_textures(const Scene& scene)
{
    std::vector<Texture> textures(scene.textures.size());
    for (const Material& material : scene.materials) {
        const std::int32_t number = material.opacity_texture.texture;
        if (material.alpha == AlphaMode::opaque || number < 0) continue;
        const auto k = std::size_t(number);
        if (textures[k].levels() == 0) textures[k] = scene.textures[k];
    }
    return textures;
}

void clear_geometry(World& world, Scene& scene)
{
    world.position.clear();
    world.normal.clear();
    scene.position.clear();
    scene.normal.clear();
    scene.uv.clear();
    scene.uv1.clear();
    scene.color.clear();
    scene.index.clear();
    scene.owner.clear();
    scene.instances.clear();
    scene.vertices = 0;
}

/// A range of columns or rows that grows with what is put into it.
struct PixelRange {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double x)
    {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

/// The pixels [first, last) of the range, out of those of a side of the region.
std::pair<int, int> clamped_to_side(const PixelRange& range, int begin, int size)
{
    const double end = double(begin) + size;
    const double first = std::clamp(std::floor(range.low - kPixelMargin), double(begin), end);
    const double last = std::clamp(std::ceil(range.high + kPixelMargin), double(begin), end);
    return {int(first), int(last)};
}

} // namespace

WorldParts::WorldParts(const World& world) : whole_(world), scene_(std::make_shared<Scene>())
{
    if (!world.scene) throw ArgumentError("the world has no scene: pose it first");
    scene_->name = world.scene->name;
    scene_->materials = world.scene->materials;
    scene_->textures = opacity_textures(*world.scene);
    scene_->nodes = {Node{}};
    part_.node_matrix = {glm::dmat4(1.0)};
    part_.node_visible = {1};
    part_.camera = world.camera;
}

const World& WorldParts::part(std::span<const std::uint32_t> instances)
{
    const Scene& from = *whole_.scene;
    // A scene of its own for each part: nobody takes it for the one before.
    part_.scene.reset();
    scene_ = std::make_shared<Scene>(std::move(*scene_));
    Scene& to = *scene_;
    clear_geometry(part_, to);
    for (const std::uint32_t number : instances) {
        if (number >= from.instances.size())
            throw ArgumentError(fmt::format("{}: there is no instance {}: it has {}", from.name,
                number, from.instances.size()));
        const Instance& instance = from.instances[number];
        const std::size_t first = instance.first_vertex, count = instance.vertex_count;
        Instance copy;
        copy.name = instance.name;
        copy.material = instance.material;
        copy.first_vertex = std::uint32_t(to.vertices);
        copy.vertex_count = instance.vertex_count;
        copy.first_triangle = std::uint32_t(to.index.size());
        copy.triangle_count = instance.triangle_count;
        append_range(part_.position, whole_.position, first, count);
        append_range(part_.normal, whole_.normal, first, count);
        append_range(to.uv, from.uv, first, count);
        append_range(to.uv1, from.uv1, first, count);
        append_range(to.color, from.color, first, count);
        const std::uint32_t moved = copy.first_vertex - instance.first_vertex;
        for (std::uint32_t t = 0; t < instance.triangle_count; ++t)
            to.index.push_back(from.index[instance.first_triangle + t] + moved);
        to.owner.resize(to.index.size(), std::uint32_t(to.instances.size()));
        to.vertices += count;
        to.instances.push_back(std::move(copy));
    }
    to.position = part_.position;
    to.normal = part_.normal;
    part_.time_s = whole_.time_s;
    part_.scene = scene_;
    return part_;
}

std::optional<Region> region_that_sees(const World& world, const View& view)
{
    const View filled = checked(view);
    const Region& all = filled.region;
    const Pencil pencil = pencil_of(filled, all, 1);
    if (pencil.parallel) return all;
    PixelRange columns, rows;
    bool before = false, behind = false; // the plane of the eye
    for (const glm::vec3& position : world.position) {
        const glm::dvec3 p = pencil.eye_from_world * (glm::dvec3(position) - pencil.eye);
        if (!(p.z > kNearestProjected)) {
            behind = true;
            before = before || p.z > 0;
            continue;
        }
        before = true;
        columns.add(p.x / p.z - pencil.x0 + all.x);
        rows.add(p.y / p.z - pencil.y0 + all.y);
    }
    if (!before) return {};
    if (behind) return all;
    const auto [left, right] = clamped_to_side(columns, all.x, all.width);
    const auto [top, bottom] = clamped_to_side(rows, all.y, all.height);
    if (left >= right || top >= bottom) return {};
    return Region{left, top, right - left, bottom - top};
}

std::vector<std::uint64_t> pixels_alone(Renderer& renderer, const World& world, const View& view,
    std::span<const std::vector<std::uint32_t>> parts)
{
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    std::vector<std::uint64_t> counts;
    counts.reserve(parts.size());
    WorldParts taken(world);
    Film film;
    for (const std::vector<std::uint32_t>& instances : parts) {
        const World& part = taken.part(instances);
        const std::optional<Region> region = region_that_sees(part, view);
        if (!region || part.scene->index.empty()) {
            counts.push_back(0);
            continue;
        }
        View small = view;
        small.region = *region;
        renderer.render(part, small, settings, film);
        const auto none = std::count(film.item.begin(), film.item.end(), kNoItem);
        counts.push_back(film.item.size() - std::uint64_t(none));
    }
    return counts;
}

} // namespace firsthit
