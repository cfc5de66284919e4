// compare_light_visibility.cpp - compares exact shadows with another ray caster, and decides each
// difference exactly.
#include "base/instruction_set.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "hits/spot_cone.h"
#include "rays/brute.h"
#include "rays/brute_shadows.h"
#ifdef FIRSTHIT_EMBREE
#include "rays/embree_occluder.h"
#endif
#include "render/check_settings.h"
#include "scene/model/check_light.h"
#include "shadow/exact/tile_hull.h"
#include "visibility/bin/project.h"

#include <firsthit/compare.h>
#include <firsthit/error.h>

#include <atomic>
#include <utility>

namespace firsthit {
namespace {

/// The hits of one picture that one light may reach: it is on the eye's side of their plane, and
/// they are inside its cone.
struct Reachable {
    std::vector<std::uint32_t> pixel;
    std::vector<glm::vec3> point; // in the light's space, lifted off its receiver
    std::vector<std::uint32_t> item;
};

/// The triangles of the world in the space of one light.
struct LightVisibilityScene {
    PencilSpace space;
    std::vector<glm::vec3> corner;
    Cutouts cutouts;
    LightTriangles triangles;

    LightVisibilityScene(const World& world, const Light& light, const glm::dvec3& eye)
        : space(light_space(light, eye, farthest_coordinate(light, world.position))),
          corner(all_to_light(space, world.position)),
          triangles{corner, world.scene->index, &cutouts}
    {
        cutouts.find(*world.scene, kShadowOpacity);
    }
    LightVisibilityScene(const LightVisibilityScene&) = delete;
    LightVisibilityScene& operator=(const LightVisibilityScene&) = delete;
};

Reachable find_reachable(
    const LightVisibilityScene& lit, const Light& light, const EyeTriangles& eye, const Film& film)
{
    Effort effort;
    Reachable reachable;
    const std::vector<float>& position = film[Aov::position].value;
    const SpotCone cone = light.kind == Light::Kind::spot ? spot_cone(light) : SpotCone{};
    for (std::size_t k = 0; k < film.item.size(); ++k) {
        const std::uint32_t item = film.item[k];
        if (item == kNoItem) continue;
        const Corners corners = lit.triangles[item];
        const int side = light_side(lit.space, corners, effort);
        if (side == 0 || side != volume_sign(eye[item], effort)) continue;
        const glm::vec3 p(position[3 * k], position[3 * k + 1], position[3 * k + 2]);
        const glm::vec3 d = to_light(lit.space, p);
        if (light.kind == Light::Kind::spot && !in_cone(cone, from_lamp(lit.space, p, d))) continue;
        reachable.pixel.push_back(std::uint32_t(k));
        reachable.point.push_back(lifted(lit.space, d, receiver_of(corners, side)));
        reachable.item.push_back(item);
    }
    return reachable;
}

std::vector<std::uint8_t> cast(Oracle oracle, const LightVisibilityScene& lit,
    const Reachable& reachable, Tasks& tasks, const std::function<void(double)>& progress)
{
    std::vector<std::uint8_t> shadowed(reachable.point.size());
    if (oracle == Oracle::brute) {
        brute_shadows(
            lit.space, lit.triangles, reachable.point, reachable.item, shadowed, tasks, progress);
    } else {
#ifdef FIRSTHIT_EMBREE
        EmbreeOccluder embree(lit.triangles, true, tasks.threads());
        embree.test(lit.space, reachable.point, reachable.item, shadowed, tasks);
#else
        throw DeviceError("this build has no Embree (FIRSTHIT_BUILD_EMBREE=OFF)");
#endif
    }
    return shadowed;
}

/// Our light visibility of one light as bytes, (height, width): 1 where the light reaches the hit.
std::vector<std::uint8_t> lit_bits(const Film& film, std::size_t light)
{
    const Plane& lit = film[Aov::lit];
    const auto lights = static_cast<std::size_t>(lit.channels);
    std::vector<std::uint8_t> bits(film.item.size());
    for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = lit.value[k * lights + light] > 0;
    return bits;
}

/// Compares the results for one light and adds the counts.
void count(const LightVisibilityScene& lit, const Reachable& reachable,
    const std::vector<std::uint8_t>& theirs, std::vector<std::uint8_t> ours, const Film& film,
    Tasks& tasks, LitComparison& result)
{
    std::atomic<std::uint64_t> agree{0}, ours_wrong{0}, theirs_wrong{0};
    tasks.for_ranges(reachable.point.size(), 4096, [&](std::size_t first, std::size_t last) {
        std::uint64_t same = 0; // counted locally, because nearly all agree
        for (std::size_t k = first; k < last; ++k) {
            const bool our_lit = std::exchange(ours[reachable.pixel[k]], std::uint8_t(0)) != 0;
            if (our_lit != (theirs[k] != 0)) {
                ++same;
                continue;
            }
            Effort effort;
            const bool shadowed = is_shadowed_brute(
                lit.space, lit.triangles, reachable.point[k], reachable.item[k], effort);
            ++(our_lit == shadowed ? ours_wrong : theirs_wrong);
        }
        agree += same;
    });
    // All other pixels should be dark: the background, and hits that the light cannot reach.
    std::uint64_t hits = 0, wrong = 0;
    for (std::size_t k = 0; k < ours.size(); ++k) {
        hits += film.item[k] != kNoItem;
        wrong += ours[k] != 0;
    }
    result.pixels += hits;
    result.agree += agree + (hits - reachable.point.size()) - wrong;
    result.ours_wrong += ours_wrong + wrong;
    result.theirs_wrong += theirs_wrong;
}

} // namespace

LitComparison compare_lit(const World& world, const View& view, Oracle oracle, int threads,
    const std::function<void(double)>& progress)
{
    select_instruction_set();
    Tasks tasks(threads);
    const View filled = checked(view);
    check_lights(world);
    Film film;
    Stats stats;
    FrameMemory memory;
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item, Aov::position, Aov::lit};
    settings.shadows = Shadows::exact;
    render_frame({world, filled, tasks, film}, settings, memory, stats);

    ViewMemory eye;
    eye.pencil = pencil_of(filled, filled.region, 1);
    reach_all(world.position, eye.pencil);
    take_triangles(*world.scene, eye);
    project_vertices(world.position, eye.pencil, eye, tasks);
    const EyeTriangles triangles{
        eye.corner.span().first(world.position.size()), world.scene->index};
    LitComparison result;
    const std::size_t lights = world.lights.size();
    for (std::size_t l = 0; l < lights; ++l) {
        const LightVisibilityScene lit(world, world.lights[l], eye.pencil.eye);
        const Reachable reachable = find_reachable(lit, world.lights[l], triangles, film);
        const auto report = [&](double share) {
            if (progress) progress((double(l) + share) / double(lights));
        };
        const std::vector<std::uint8_t> theirs = cast(oracle, lit, reachable, tasks, report);
        count(lit, reachable, theirs, lit_bits(film, l), film, tasks, result);
    }
    return result;
}

} // namespace firsthit
