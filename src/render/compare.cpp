// compare.cpp - compares the item buffer with another ray caster, and decides each difference
// exactly.
#include "base/instruction_set.h"
#include "base/tasks.h"
#include "cpu/frame.h"
#include "rays/brute.h"
#ifdef FIRSTHIT_EMBREE
#include "rays/embree_caster.h"
#endif
#include "render/check_settings.h"
#include "visibility/bin/project.h"

#include <firsthit/compare.h>
#include <firsthit/error.h>

#include <atomic>

namespace firsthit {
namespace {

std::vector<std::uint32_t> cast(Oracle oracle, const EyeTriangles& triangles, const Pencil& pencil,
    Tasks& tasks, const std::function<void(double)>& progress)
{
    std::vector<std::uint32_t> items(std::size_t(pencil.width) * std::size_t(pencil.height));
    if (oracle == Oracle::brute) {
        cast_brute(triangles, pencil, items, tasks, progress);
    } else {
#ifdef FIRSTHIT_EMBREE
        EmbreeCaster embree(triangles, true, false, tasks.threads());
        embree.cast(pencil, items, {}, tasks);
#else
        throw DeviceError("this build has no Embree (FIRSTHIT_BUILD_EMBREE=OFF)");
#endif
    }
    return items;
}

} // namespace

Comparison compare(const World& world, const View& view, Oracle oracle, int threads,
    const std::function<void(double)>& progress)
{
    select_instruction_set();
    Tasks tasks(threads);
    const View filled = checked(view);
    Film film;
    Stats stats;
    FrameMemory memory;
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    render_frame({world, filled, tasks, film}, settings, memory, stats);

    // The oracle uses the same eye space, computed here from the pencil of the whole region.
    ViewMemory eye;
    eye.pencil = pencil_of(filled, filled.region, 1);
    reach_all(world.position, eye.pencil);
    take_triangles(*world.scene, eye);
    project_vertices(world.position, eye.pencil, eye, tasks);
    const EyeTriangles triangles{
        eye.corner.span().first(world.position.size()), world.scene->index, &eye.cutouts};
    const std::vector<std::uint32_t> theirs = cast(oracle, triangles, eye.pencil, tasks, progress);

    Comparison result;
    result.pixels = theirs.size();
    std::atomic<std::uint64_t> agree{0}, ties{0}, ours_wrong{0}, theirs_wrong{0};
    tasks.for_ranges(theirs.size(), 4096, [&](std::size_t first, std::size_t last) {
        std::uint64_t same = 0; // counted locally, because nearly all agree
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t a = film.item[i], b = theirs[i];
            if (a == b) {
                ++same;
                continue;
            }
            const glm::vec3 d = direction_of(eye.pencil, i);
            Effort effort;
            if (cast_brute(triangles, d, effort) != a)
                ++ours_wrong;
            else
                ++(is_tie(triangles, a, b, d) ? ties : theirs_wrong);
        }
        agree += same;
    });
    result.agree = agree;
    result.ties = ties;
    result.ours_wrong = ours_wrong;
    result.theirs_wrong = theirs_wrong;
    return result;
}

} // namespace firsthit
