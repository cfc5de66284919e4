// gpu_frame.cpp - the gpu engine: makes a picture of a posed world with OpenGL alone.
#include "gl/gpu_frame.h"

#include "film/film_size.h"
#include "gl/bindings.h"
#include "base/pixel_steps.h"
#include "hits/item_repair.h"
#include "shadow/sky/sky_rays.h"

#include <algorithm>

namespace firsthit::gl {

/// The arguments of a call of render().
struct GpuFrame::Job {
    const FrameContext& context;
    const Settings& settings;
    const GpuSources& sources;
    Stats& stats;
    bool shadows;

    const World& world() const { return context.world; }
    Film& film() const { return context.film; }
};

/// One pass over the whole picture.
struct GpuFrame::Pass {
    int samples; // on a pixel's side
    bool color, planes;
};

/// A section of the picture: a rectangle that is small enough to be rendered at once.
struct GpuFrame::Section {
    Region pixels; // of the picture
    int samples;   // on a pixel's side
    bool color, planes;

    std::uint64_t sample_count() const
    {
        return std::uint64_t(pixels.width) * std::uint64_t(pixels.height) *
               std::uint64_t(samples * samples);
    }
};

namespace {

/// Number of stages of a section. After each one, the frame's progress advances by its samples.
constexpr std::uint64_t kStages = 5;

HitTest hit_test(Multisample multisample)
{
    switch (multisample) {
    case Multisample::exact:
        return HitTest::take_item;
    case Multisample::none:
        return HitTest::test_item;
    case Multisample::lazy3:
    case Multisample::lazy5:
        return HitTest::try_neighbours;
    case Multisample::full3:
    case Multisample::full5:
        return HitTest::try_all;
    }
    return HitTest::test_item;
}

FrameData frame_data(const FrameContext& frame, const Settings& settings, const Pencil& pencil,
    const Region& section)
{
    const World& world = frame.world;
    const PixelSteps steps = PixelSteps::of(settings.interleave);
    FrameData data{.rays = world_rays(pencil, pencil.tile(0, 0)),
        .shear = glm::vec3(pencil.shear),
        .lights = std::int32_t(world.lights.size()),
        .background = world.scene->background,
        .reach = reach_of(settings.multisample),
        .ambient = world.scene->ambient,
        .bias = float(settings.shadow_bias),
        .size = {pencil.width, pencil.height},
        .corner = {section.x, section.y},
        .triangles = std::uint32_t(world.scene->index.size()),
        .filter_size = settings.shadow_filter,
        .steps = {steps.x, steps.y}};
    if (settings.sky.directions > 0) {
        data.sky = 1;
        data.sky_up = glm::vec3(zenith_of(settings.sky, frame.view.camera.up));
        data.sky_color = settings.sky.color;
        data.sky_ground = settings.sky.ground;
    }
    return data;
}

int channels_of(ItemFormat format)
{
    return format == ItemFormat::r32ui ? 1 : format == ItemFormat::rgb8 ? 3 : 4;
}

void add_counts(const SampleCounts& samples, std::uint64_t interpolated, Stats& stats)
{
    stats.hits += samples.hits;
    stats.missed += samples.missed;
    stats.interpolated += interpolated;
}

} // namespace

GpuFrame::GpuFrame(const Context& context, const GpuOptions& options)
    : context_(context),
      options_(options),
      scene_(context, Detail::surfaces),
      passes_(options.count_invocations)
{
}

/// Milliseconds since the last call. A software driver is waited for, so each stage gets its own
/// time. Hardware is not, so the last stage, which reads the picture, gets the time of all.
double GpuFrame::stage_ms()
{
    if (!context_.is_hardware()) glFinish();
    return watch_.lap_ms();
}

void GpuFrame::find_shadows(const Job& job, const Rays& rays, bool stored)
{
    if (job.sources.maps) {
        shadows_.use_maps(job.world(), *job.sources.maps, rays, context_.info().max_storage_bytes);
        return;
    }
    bounds_.resize(job.world().lights.size());
    passes_.find_bounds(stored, bounds_);
    shadows_.update_maps({job.world(), job.settings, scene_, rays, bounds_},
        context_.info().max_storage_bytes, job.context.tasks);
}

void GpuFrame::render_section(const Job& job, const Section& section)
{
    const Pencil pencil = pencil_of(job.context.view, section.pixels, section.samples);
    const auto stage_done = [&](double& ms) {
        ms += stage_ms();
        job.context.add(section.sample_count(), 0);
    };
    watch_.lap_ms();

    // Pose the scene.
    scene_.pose(job.world(), pencil);
    materials_.update(*job.world().scene, context_.info().max_storage_bytes);
    stage_done(job.stats.setup_ms);

    // Find the triangle that each sample sees.
    const ItemTexture items =
        job.sources.items.draw(job.world(), pencil, job.settings, scene_, job.context.tasks);
    stage_done(job.stats.raster_ms);

    // Find the exact hits.
    FrameData data = frame_data(job.context, job.settings, pencil, section.pixels);
    if (!section.color) data.steps = {1, 1};
    const Scene& scene = *job.world().scene;
    const bool environment =
        section.color && (has_reflected_environment(scene) || shows_environment(scene));
    environment_.update(scene.environment, environment, data);
    passes_.start(data, {.test = hit_test(job.settings.multisample),
                            .item_channels = channels_of(items.format),
                            .shadow_maps = job.shadows,
                            .textures = scene_.has_uv() || scene_.has_uv1(),
                            .uv1 = scene_.has_uv1(),
                            .colors = scene_.has_color(),
                            .tangents = scene_.has_tangent(),
                            .few_lights = job.world().lights.size() <= kFewLights,
                            .environment = environment,
                            .only_model = materials_.only_model()});
    glBindTextureUnit(kItemsUnit, items.name);
    scene_textures_.bind(scene_);
    materials_.bind();
    if (environment) environment_.bind();
    // What is masked keeps the background's colour.
    const bool masked = job.settings.opengl.passes == GpuPasses::multi && !shows_environment(scene);
    const bool stored = masked || section.planes || !section.color;
    if (masked) passes_.mask_empty();
    if (stored) passes_.find_hits(masked);
    stage_done(job.stats.resolve_ms);

    // Find the lights that reach the hits.
    const Rays eye_rays = world_rays(pencil, {}); // of (X, Y, 1) in eye space
    shadows_.set_lights(job.world(), eye_rays);
    if (job.shadows) find_shadows(job, eye_rays, stored);
    stage_done(job.stats.shadow_ms);

    // Compute the colours.
    const std::size_t first =
        std::size_t(section.pixels.y - job.context.view.region.y) * std::size_t(job.film().width) +
        std::size_t(section.pixels.x - job.context.view.region.x);
    if (section.color) {
        passes_.shade({.stored = stored, .masked = masked});
        const bool averaged = section.samples > 1;
        SampleCounts counts;
        if (averaged) {
            counts = passes_.count_colors();
            passes_.average(section.samples);
        }
        if (job.settings.interpolate) passes_.fill_holes();
        const SampleCounts last = passes_.count_colors();
        add_counts(averaged ? counts : last, last.interpolated, job.stats);
    } else {
        add_counts(passes_.count_hits(), 0, job.stats);
    }
    job.stats.shade_ms += stage_ms();
    if (section.color) passes_.read_colors(&job.film().color.value[3 * first], job.film().width);
    if (section.planes) read_planes(job, section, stored);
    job.context.add(section.sample_count(), 0);
}

void GpuFrame::read_planes(const Job& job, const Section& section, bool stored)
{
    const auto width = std::size_t(job.film().width);
    const std::size_t first = std::size_t(section.pixels.y - job.context.view.region.y) * width +
                              std::size_t(section.pixels.x - job.context.view.region.x);
    for (const Aov aov : job.settings.aovs) {
        Plane& plane = job.film()[aov];
        if (aov == Aov::item) {
            passes_.read_plane(aov, stored, 0, &job.film().item[first], job.film().width);
        } else if (aov != Aov::lit) {
            const auto channels = std::size_t(aov_channels(aov));
            passes_.read_plane(aov, stored, 0, &plane.value[channels * first], job.film().width);
        } else {
            // In the film, the values of all lights of a pixel are adjacent.
            const std::size_t lights = job.world().lights.size();
            const auto w = std::size_t(section.pixels.width),
                       h = std::size_t(section.pixels.height);
            plane_.resize(w * h);
            for (std::size_t light = 0; light < lights; ++light) {
                passes_.read_plane(aov, stored, light, plane_.data(), section.pixels.width);
                for (std::size_t y = 0; y < h; ++y)
                    for (std::size_t x = 0; x < w; ++x)
                        plane.value[(first + y * width + x) * lights + light] = plane_[y * w + x];
            }
        }
    }
}

void GpuFrame::render_pass(const Job& job, const Pass& pass)
{
    const int side =
        std::min(options_.section_side, context_.info().max_texture_size) / pass.samples;
    const Region& all = job.context.view.region;
    for (int y = 0; y < all.height; y += side)
        for (int x = 0; x < all.width; x += side)
            render_section(job, {.pixels = {all.x + x, all.y + y, std::min(side, all.width - x),
                                     std::min(side, all.height - y)},
                                    .samples = pass.samples,
                                    .color = pass.color,
                                    .planes = pass.planes});
}

void GpuFrame::render(
    const FrameContext& context, const Settings& settings, const GpuSources& sources, Stats& stats)
{
    const std::size_t lights = context.world.lights.size();
    const Region& region = context.view.region;
    resize(context.film, region, {settings.color, settings.aovs, lights});
    const bool shadows = settings.shadows != Shadows::none && lights > 0;
    const std::uint64_t updates = shadows_.updates(), uploaded = uploaded_bytes();
    const Job job{context, settings, sources, stats, shadows};
    // Planes belong to the ray through the centre of every pixel. With several samples in a pixel,
    // or with interleaving, they need a second pass.
    const bool planes = !settings.aovs.empty();
    const bool together = settings.samples == 1 && settings.interleave == 1;
    const bool first = settings.color || together, second = planes && !together;
    const std::uint64_t pixels = std::uint64_t(region.width) * std::uint64_t(region.height);
    const std::uint64_t samples = std::uint64_t(settings.samples * settings.samples);
    context.begin(kStages * pixels * ((first ? samples : 0) + (second ? 1 : 0)));
    if (first) render_pass(job, {settings.samples, settings.color, planes && together});
    if (second) render_pass(job, {1, false, true});
    stats.map_updates += shadows_.updates() - updates;
    stats.uploaded_bytes += uploaded_bytes() - uploaded;
    check("rendering a frame");
}

} // namespace firsthit::gl
