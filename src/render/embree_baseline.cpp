// embree_baseline.cpp - the public baseline: poses the scene, checks arguments, updates the tree,
// renders.
#include "base/instruction_set.h"
#include "base/stopwatch.h"
#include "base/tasks.h"
#include "render/camera_planes.h"
#include "render/check_settings.h"
#include "render/id_planes.h"
#include "render/surface_planes.h"
#include "scene/model/check_light.h"
#include "scene/animate/pose.h"
#ifdef FIRSTHIT_EMBREE
#include "baseline/embree_frame.h"
#endif

#include <firsthit/error.h>
#include <firsthit/baseline.h>

#include <fmt/format.h>

#include <new>
#include <utility>

namespace firsthit {

std::string_view baseline_update_name(BaselineUpdate update)
{
    switch (update) {
    case BaselineUpdate::refit_instances:
        return "refit-instances";
    case BaselineUpdate::refit:
        return "refit";
    case BaselineUpdate::rebuild_low:
        return "rebuild-low";
    case BaselineUpdate::rebuild_medium:
        return "rebuild-medium";
    case BaselineUpdate::rebuild_high:
        return "rebuild-high";
    }
    return "";
}

#ifdef FIRSTHIT_EMBREE

struct EmbreeBaseline::Impl {
    Impl(std::shared_ptr<const Scene> of, BaselineUpdate update, int threads, int asked_packet)
        : scene(std::move(of)),
          tasks(threads),
          tree(*scene, update, tasks.threads()),
          packet(asked_packet != 0 ? asked_packet : tree.widest_packet())
    {
        if (packet != 8 && packet != 16)
            throw ArgumentError(fmt::format("Embree's packets have 8 or 16 rays, not {}", packet));
        select_instruction_set();
        world.position.reserve(scene->vertices + 2); // Embree reads 16 bytes of a vertex
    }

    std::shared_ptr<const Scene> scene;
    Tasks tasks;
    World world;
    EmbreeTree tree;
    int packet; // rays
    EmbreeFrameMemory memory;
    IdPlanes id_planes;
    SurfacePlanes surface_planes;
    CameraPlanes camera_planes;
    Settings own; // without the planes that follow from others
    BaselineStats stats;
    double pose_ms = 0; // since the last frame
};

EmbreeBaseline::EmbreeBaseline(
    std::shared_ptr<const Scene> scene, BaselineUpdate update, int threads, int packet)
    : impl_(std::make_unique<Impl>(std::move(scene), update, threads, packet))
{
}

const World& EmbreeBaseline::pose(double time_s)
{
    Stopwatch watch;
    firsthit::pose(impl_->scene, PoseSettings{.time_s = time_s}, impl_->world, impl_->tasks);
    impl_->pose_ms += watch.lap_ms();
    return impl_->world;
}

void EmbreeBaseline::assume_moved()
{
    impl_->tree.assume_moved();
}

void EmbreeBaseline::render(const View& view, const Settings& settings, Film& film)
{
    Impl& impl = *impl_;
    if (!impl.world.scene) pose(0);
    check(settings, impl.world.lights.size());
    if (settings.samples != 1 || settings.interleave != 1)
        throw ArgumentError("Embree's frame has one ray a pixel: accepted is 1 for samples and "
                            "for interleave");
    if (settings.sky.directions > 0)
        throw ArgumentError("Embree's frame has no sky: accepted is a sky of 0 directions");
    if (settings.alpha) throw ArgumentError("Embree's frame makes no alpha: accepted is false");
    if (settings.shadows == Shadows::map)
        throw ArgumentError(
            "Embree's frame has no shadow maps: accepted are exact shadows or none");
    if (has_cutouts(*impl.world.scene) || has_blended_triangles(*impl.world.scene))
        throw ArgumentError(
            "Embree's frame knows no cut-outs and no blended surfaces, which materials "
            "of the scene ask for (alpha mask or blend)");
    check_lights(impl.world);
    const View filled = checked(view);
    check_previous(impl.world, filled, settings.previous);
    impl.id_planes.without(settings, impl.own);
    impl.surface_planes.without(impl.own);
    impl.camera_planes.without(impl.own);
    impl.stats = {};
    impl.stats.pose_ms = std::exchange(impl.pose_ms, 0);
    Stopwatch watch;
    double after_ms = 0;
    try {
        impl.stats.updated_triangles = impl.tree.update(impl.world);
        impl.stats.update_ms = watch.lap_ms();
        render_embree({impl.world, filled, impl.tasks, film}, impl.own, {impl.tree, impl.packet},
            impl.memory, impl.stats);
        impl.camera_planes.fill(filled, impl.tasks, film);
        impl.surface_planes.fill(impl.world, filled, settings, impl.tasks, film);
        impl.id_planes.fill(*impl.world.scene, impl.tasks, film);
        after_ms = watch.lap_ms();
    } catch (const std::bad_alloc&) {
        throw Error("not enough memory for a picture of this size");
    }
    impl.stats.total_ms = impl.stats.pose_ms + impl.stats.update_ms + after_ms;
}

const BaselineStats& EmbreeBaseline::stats() const
{
    return impl_->stats;
}

int EmbreeBaseline::threads() const
{
    return impl_->tasks.threads();
}

int EmbreeBaseline::packet() const
{
    return impl_->packet;
}

std::string baseline_version()
{
    return fmt::format("Embree {}", RTC_VERSION_STRING);
}

#else

struct EmbreeBaseline::Impl {};

EmbreeBaseline::EmbreeBaseline(std::shared_ptr<const Scene>, BaselineUpdate, int, int)
{
    throw DeviceError("this build has no Embree (FIRSTHIT_BUILD_EMBREE=OFF)");
}
const World& EmbreeBaseline::pose(double)
{
    throw DeviceError("this build has no Embree (FIRSTHIT_BUILD_EMBREE=OFF)");
}
void EmbreeBaseline::assume_moved() {}
void EmbreeBaseline::render(const View&, const Settings&, Film&)
{
    pose(0);
}
const BaselineStats& EmbreeBaseline::stats() const
{
    static const BaselineStats none;
    return none;
}
int EmbreeBaseline::threads() const
{
    return 0;
}
int EmbreeBaseline::packet() const
{
    return 0;
}
std::string baseline_version()
{
    return {};
}

#endif

EmbreeBaseline::~EmbreeBaseline() = default;

} // namespace firsthit
