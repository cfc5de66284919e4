// view_session.cpp - one who looks at a scene: switches, time and frames.
#include "view/session/view_session.h"

#include "common/usage.h"
#include "options/engine_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit::cli::view {
namespace {

/// After the last input that moves the camera, the exact picture waits this long, so that it is not begun
/// and given up between two events.
constexpr std::chrono::milliseconds kStillMoving{120};
/// A turn of the turntable.
constexpr double kTurnSeconds = 12;
/// How far flying goes in a second, in distances to the point in the middle.
constexpr double kFlySpeed = 0.8;
/// Frames have at least this share of the time, however long showing them takes.
constexpr double kLeastShare = 0.4;
/// A longer time between two updates is a pause of the program, not of the clip.
constexpr double kLongestStep = 0.25;

} // namespace

ViewSession::ViewSession(
    const RenderOptions& options, std::function<void()> has_news, RecentFiles recent)
    : options_(options),
      recent_(std::move(recent)),
      given_environment_(options.environment),
      has_news_(std::move(has_news)),
      frames_(options.threads, has_news_)
{
    take_scene(std::make_shared<ViewScene>(options), false);
}

ViewSession::~ViewSession() = default;

void ViewSession::take_scene(std::shared_ptr<ViewScene> scene, bool keep)
{
    const ViewState before = state_;
    scene_ = std::move(scene);
    recent_.add(scene_->options().scene.name);
    environment_ = state_.environment;
    seen_box_ = scene_->box();
    seen_t_ = 0;
    state_.settings.sky = scene_->settings().sky;
    state_.studio = scene_->in_studio();
    state_.selected = -1;
    if (!keep) {
        const Settings settings = scene_->settings();
        if (number_ == 1) { // what the options say; afterwards what was chosen stays
            state_.settings = settings;
            state_.tone = scene_->options().environment.tone;
            state_.dither = scene_->options().picture.dither;
        }
        state_.clip = scene_->start().clip;
        state_.time_s = scene_->start().time_s;
        state_.camera = scene_->start().camera;
        mover_.reset();
    } else if (!scene_->first().has_clip(state_.clip)) {
        state_.clip = scene_->start().clip;
    }
    if (keep && before.studio == state_.studio) state_.settings.sky = before.settings.sky;
    clamp_time();
    changed(false);
}

void ViewSession::changed(bool camera, bool input)
{
    ++number_;
    picks_ = false;
    const Clock::time_point now = Clock::now();
    if (camera) moving_until_ = now + kStillMoving;
    if (input) history_.note_input(number_, now);
}

CameraMover& ViewSession::mover()
{
    if (!mover_) {
        const std::shared_ptr<const ShownFrame> frame = latest();
        const bool current = frame && frame->request.scene == scene_;
        mover_.emplace();
        mover_->take(current ? frame->camera : scene_->start_camera(), seen_box_, scene_->up_axis(),
            height_);
        mover_->focus(seen_t_, seen_box_);
    }
    return *mover_;
}

/// Remembers where things are, for a hand that turns the camera before the next picture is at rest.
void ViewSession::note_what_is_seen()
{
    const std::shared_ptr<const ShownFrame> frame = latest();
    if (!frame || frame->request.moving || frame->request.scene != scene_) return;
    seen_box_ = frame->box;
    if (frame->request.number == number_) seen_t_ = frame->middle_t;
}

void ViewSession::resize(int width, int height)
{
    if (width < 1 || height < 1 || (width == width_ && height == height_)) return;
    width_ = width;
    height_ = height;
    changed(false);
}

void ViewSession::choose_switch(const std::string& name, const std::string& value)
{
    const Switch& chosen = switch_named(name);
    ViewState next = state_;
    choose(chosen, value, next);
    const std::size_t clips = scene_->first().clips.size();
    const std::size_t cameras = scene_->first().cameras.size();
    if (next.clip > 0 && std::size_t(next.clip) >= clips)
        throw UsageError(fmt::format("clip: '{}' is not accepted: the scene has {}", value, clips));
    if (next.camera > 0 && std::size_t(next.camera) >= cameras)
        throw UsageError(
            fmt::format("camera: '{}' is not accepted: the scene has {}", value, cameras));
    const bool clip = next.clip != state_.clip;
    const bool lit = next.studio != state_.studio || next.environment != state_.environment;
    if (next.camera != state_.camera || name == "camera") mover_.reset();
    // Two ways of shooting more or less than a ray a pixel exclude one another.
    Settings& settings = next.settings;
    if (name == "samples" && settings.samples > 1) settings.adaptive = settings.interleave = 1;
    if (name == "aa" && settings.adaptive > 1) settings.samples = settings.interleave = 1;
    if (name == "interleave" && settings.interleave > 1) settings.samples = settings.adaptive = 1;
    if (name == "sky" && settings.sky.directions > 0 && state_.settings.sky.directions == 0)
        settings.sky.up = scene_->up_axis();
    state_ = next;
    if (clip) state_.time_s = scene_->begin_s(state_.clip);
    clamp_time();
    if (lit) relight();
    changed(name == "time" || name == "turntable");
}

void ViewSession::clamp_time()
{
    const double begin = scene_->begin_s(state_.clip), end = scene_->end_s(state_.clip);
    if (end > begin)
        state_.time_s = std::clamp(state_.time_s, begin, end);
    else
        state_.playing = false;
}

void ViewSession::pass_time(double seconds)
{
    const double begin = scene_->begin_s(state_.clip), end = scene_->end_s(state_.clip);
    if (state_.playing && end > begin) {
        double time = state_.time_s + seconds * state_.speed;
        if (time > end || time < begin) {
            if (state_.loop) {
                time = begin +
                       std::fmod(std::fmod(time - begin, end - begin) + (end - begin), end - begin);
            } else {
                time = std::clamp(time, begin, end);
                state_.playing = false;
            }
        }
        state_.time_s = time;
        changed(false, false);
    }
    if (state_.turntable) {
        mover().orbit(seconds * 2 * std::numbers::pi / kTurnSeconds, 0);
        changed(true, false);
    }
    fly(seconds);
}

void ViewSession::fly(double seconds)
{
    const auto axis = [&](const char* ahead, const char* back) {
        return double(keys_.contains(ahead)) - double(keys_.contains(back));
    };
    const glm::dvec3 moved(axis("d", "a"), axis("e", "q"), axis("w", "s"));
    if (moved == glm::dvec3(0)) return;
    mover().fly(moved * (kFlySpeed * seconds));
    changed(true, false);
}

bool ViewSession::is_moving(Clock::time_point now) const
{
    const bool runs = state_.playing && scene_->end_s(state_.clip) > scene_->begin_s(state_.clip);
    return runs || state_.turntable || now < moving_until_;
}

bool ViewSession::is_at_rest(Clock::time_point now) const
{
    if (is_moving(now) || loading_.valid()) return false;
    if (has_failed()) return true;
    const std::shared_ptr<const ShownFrame> frame = latest();
    return frame && !frame->request.moving && frame->request.number == number_;
}

FrameRequest ViewSession::request(Clock::time_point now) const
{
    FrameRequest wanted{.number = number_, .scene = scene_};
    wanted.pose = {.time_s = state_.time_s, .clip = state_.clip, .camera = state_.camera};
    if (mover_) wanted.camera = mover_->camera();
    wanted.width = width_;
    wanted.height = height_;
    wanted.state = state_;
    wanted.moving = is_moving(now);
    const double period_ms = 1000 / state_.rate;
    wanted.most_ms = std::max(kLeastShare * period_ms, period_ms - showing_ms_);
    return wanted;
}

void ViewSession::update(Clock::time_point now)
{
    history_.note_turn(now);
    if (last_update_ == Clock::time_point{}) last_update_ = now;
    const double seconds = std::chrono::duration<double>(now - last_update_).count();
    last_update_ = now;
    pass_time(std::min(seconds, kLongestStep));
    take_loaded();
    watch_files(now);
    frames_.want(request(now));
    note_what_is_seen();
    record(now);
    const bool inside =
        pointer_.x >= 0 && pointer_.y >= 0 && pointer_.x < width_ && pointer_.y < height_;
    if (state_.hover && inside && is_at_rest(now) && !picks_) {
        frames_.want_pick(int(pointer_.x), int(pointer_.y));
        picks_ = true;
    }
    if (is_moving(now)) picks_ = false;
}

std::optional<Pick> ViewSession::latest_pick() const
{
    std::optional<Pick> found = frames_.latest_pick();
    if (found && (found->x != int(pointer_.x) || found->y != int(pointer_.y))) found.reset();
    return found;
}

void ViewSession::note_showing(double ms)
{
    showing_ms_ = 0.9 * showing_ms_ + 0.1 * ms;
}

void ViewSession::shown(const ShownFrame& frame, Clock::time_point when)
{
    history_.note_shown(frame, when);
}

std::string ViewSession::camera_options() const
{
    if (mover_) return mover_->as_options();
    CameraMover taken;
    const std::shared_ptr<const ShownFrame> frame = latest();
    taken.take(
        frame ? frame->camera : scene_->start_camera(), scene_->box(), scene_->up_axis(), height_);
    return taken.as_options();
}

std::optional<std::string> ViewSession::take_copied()
{
    return std::exchange(copied_, {});
}

std::string ViewSession::corner(Clock::time_point now) const
{
    const std::shared_ptr<const ShownFrame> frame = latest();
    if (!frame) return "the first frame is made";
    const Settings& settings = frame->request.state.settings;
    const bool maps = settings.shadows == Shadows::map || (settings.shadows == Shadows::automatic &&
                                                              frame->engine.engine != Engine::cpu);
    std::string what;
    if (!frame->missing.empty())
        what = "without " + frame->missing;
    else if (frame->request.moving)
        what = "nothing left out";
    else if (frame->engine.engine != Engine::cpu || maps || settings.interleave > 1)
        what = fmt::format("final, {} engine", engine_name(frame->engine.engine));
    else
        what = "exact";
    const bool current = frame->request.number == number_ && !frame->request.moving;
    const double age = std::chrono::duration<double, std::milli>(now - frame->state_time).count();
    std::string text = fmt::format("{} | {} | {}x{}", what,
        current ? "at rest" : fmt::format("{:.0f} ms old", age), frame->width, frame->height);
    if (frame->width != width_ || frame->height != height_)
        text += fmt::format(" of {}x{}", width_, height_);
    if (recorder_) text += fmt::format(" | film {:.1f} s", recorder_->length_s());
    return text;
}

} // namespace firsthit::cli::view
