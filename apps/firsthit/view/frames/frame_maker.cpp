// frame_maker.cpp - makes one picture of a session after the other.
#include "view/frames/frame_maker.h"

#include "common/stopwatch.h"
#include "view/frames/light_view.h"
#include "view/frames/looks.h"

#include <firsthit/picture.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::view {
namespace {

Box box_of(const World& world)
{
    const std::array<glm::vec3, 2> box = bounds(world);
    return {glm::dvec3(box[0]), glm::dvec3(box[1])};
}

std::optional<Box> box_of_instance(const World& world, std::int32_t number)
{
    if (number < 0 || std::size_t(number) >= world.scene->instances.size()) return {};
    const Instance& instance = world.scene->instances[std::size_t(number)];
    if (instance.vertex_count == 0) return {};
    Box box{glm::dvec3(world.position[instance.first_vertex]),
        glm::dvec3(world.position[instance.first_vertex])};
    for (std::uint32_t k = 0; k < instance.vertex_count; ++k) {
        const glm::dvec3 p(world.position[instance.first_vertex + k]);
        box[0] = glm::min(box[0], p);
        box[1] = glm::max(box[1], p);
    }
    return box;
}

/// The settings that are free of all that is approximate.
Settings exact_settings(const Settings& given, Look look)
{
    Settings settings = given;
    settings.engine = Engine::cpu;
    if (settings.shadows != Shadows::none) settings.shadows = Shadows::exact;
    settings.interleave = 1;
    settings.aovs.clear();
    if (look == Look::wrong) {
        settings.color = settings.alpha = false;
        settings.aovs = {Aov::item};
    }
    return settings;
}

bool same_look(const FrameRequest& a, const FrameRequest& b)
{
    return a.scene == b.scene && a.width == b.width && a.height == b.height &&
           a.state.look == b.state.look && a.state.settings.engine == b.state.settings.engine &&
           a.state.settings.shadows == b.state.settings.shadows &&
           a.state.settings.sky.directions == b.state.settings.sky.directions &&
           a.state.settings.samples == b.state.settings.samples &&
           a.state.settings.adaptive == b.state.settings.adaptive;
}

} // namespace

void FrameMaker::take_pose(const FrameRequest& request)
{
    const std::shared_ptr<const Scene> scene = request.scene->scene_at(request.pose.time_s);
    const bool posed = world_.scene == scene && pose_.time_s == request.pose.time_s &&
                       pose_.clip == request.pose.clip && pose_.camera == request.pose.camera;
    if (posed) return;
    world_.scene.reset(); // of no use where posing fails
    renderer_.pose(scene, request.pose, world_);
    pose_ = request.pose;
}

Rung FrameMaker::rung_of(const FrameRequest& request, int& number, int& count)
{
    const Scene& scene = *world_.scene;
    const bool background = scene.environment.map && scene.environment.background;
    std::vector<Rung> rungs = rungs_of(request.state.settings, !background);
    if (!request.moving || !request.state.hold_rate) {
        number = -1;
        return rungs[0];
    }
    if (!same_look(request, last_)) ladder_.reset();
    count = int(rungs.size());
    number = ladder_.rung(count);
    return rungs[std::size_t(number)];
}

void FrameMaker::render_reference(
    const FrameRequest& request, const Settings& whole, const FrameControl& control)
{
    if (!exact_) exact_ = std::make_unique<Renderer>(threads_);
    exact_->render(world_, view_, exact_settings(whole, request.state.look), reference_, control);
}

void FrameMaker::make(const FrameRequest& request, const std::stop_token& stop, ShownFrame& shown)
{
    const Stopwatch watch;
    FrameControl control;
    control.stop = stop;
    shown.state_time = Clock::now();
    take_pose(request);
    int number = -1, count = 0;
    const Rung rung = rung_of(request, number, count);
    const auto scaled = [&](int side) { return std::max(1, int(std::lround(side * rung.scale))); };
    const Camera* camera = request.camera ? &*request.camera : nullptr;
    view_ = request.scene->view(world_, scaled(request.width), scaled(request.height), camera);

    shown.camera = view_.camera;
    const Look look = request.state.look;
    if (look == Look::light_view && !world_.lights.empty())
        view_.camera = camera_of_light(
            world_.lights[std::min(std::size_t(request.state.light), world_.lights.size() - 1)],
            box_of(world_));

    Settings settings = rung.settings;
    shown.note = ask_for_planes(look, world_.lights.size(), settings);
    const bool outlined = request.state.selected >= 0 &&
                          std::size_t(request.state.selected) < world_.scene->instances.size();
    if (outlined &&
        std::find(settings.aovs.begin(), settings.aovs.end(), Aov::instance) == settings.aovs.end())
        settings.aovs.push_back(Aov::instance);
    Film& film = request.moving ? moving_ : shown.film;
    renderer_.render(world_, view_, settings, film, control);
    shown.stats = renderer_.stats();
    shown.engine = renderer_.engine();
    const bool compares = look == Look::difference || look == Look::wrong;
    if (compares) render_reference(request, rung.settings, control);
    const auto& gradient = request.scene->options().picture.backdrop.gradient;
    if (gradient && settings.alpha) lay_over(film, *gradient, 0, view_.height);

    const Painting painting{.look = look,
        .light = request.state.light,
        .tone = request.state.tone,
        .dither = request.state.dither,
        .exact = !request.moving,
        .selected = outlined ? request.state.selected : -1,
        .reference = compares ? &reference_ : nullptr};
    paint(film, painting, shown.rgba);
    shown.request = request;
    shown.width = view_.width;
    shown.height = view_.height;
    shown.missing = rung.missing;
    if (!request.moving) {
        shown.box = box_of(world_);
        shown.selected = box_of_instance(world_, request.state.selected);
        shown.middle_t = seen_t(picks_, world_, view_, view_.width / 2, view_.height / 2);
    } else {
        shown.middle_t = 0;
        shown.film.width = 0; // the film is of another frame
        shown.box = {};
        shown.selected.reset();
    }
    shown.made_ms = watch.ms();
    if (number >= 0) ladder_.made(number, shown.made_ms, request.most_ms, count, Clock::now());
    last_ = request;
}

Pick FrameMaker::pick(int x, int y)
{
    return view::pick(picks_, world_, view_, last_.state.settings, x, y);
}

} // namespace firsthit::cli::view
