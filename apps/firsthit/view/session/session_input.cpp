// session_input.cpp - what keys, buttons and the wheel do to a session.
#include "view/session/view_session.h"

#include "common/usage.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace firsthit::cli::view {
namespace {

/// A drag over the height of the picture turns the camera by this.
constexpr double kTurnRad = std::numbers::pi;
/// A press that moves less than this is a click, pixels.
constexpr double kClick = 4;
/// A step of the wheel.
constexpr double kZoomStep = 0.9;
/// Of arrow keys, radians.
constexpr double kArrowRad = std::numbers::pi / 24;

} // namespace

void ViewSession::pointer_moves(double x, double y)
{
    const glm::dvec2 now(x, y), moved = (now - pointer_) / double(height_);
    if (now == pointer_) return;
    pointer_ = now;
    picks_ = false;
    if (!held_) return;
    const glm::dvec2 way = now - pressed_at_;
    if (!dragged_ && std::hypot(way.x, way.y) < kClick) return;
    dragged_ = true;
    if (*held_ == Button::right)
        mover().look(-moved.x * kTurnRad / 2, -moved.y * kTurnRad / 2);
    else if (*held_ == Button::middle || shift_)
        mover().pan(moved);
    else
        mover().orbit(-moved.x * kTurnRad, moved.y * kTurnRad);
    changed(true);
}

void ViewSession::button(Button button, bool down, bool shift)
{
    if (down) {
        if (held_) return;
        held_ = button;
        shift_ = shift;
        dragged_ = false;
        pressed_at_ = pointer_;
        const std::shared_ptr<const ShownFrame> frame = latest();
        const bool rests = frame && !frame->request.moving && frame->request.number == number_;
        if (mover_ && rests) mover_->focus(frame->middle_t, frame->box);
        return;
    }
    if (held_ != button) return;
    held_.reset();
    if (button == Button::left && !dragged_) click();
}

void ViewSession::click()
{
    const std::optional<Pick> found = latest_pick();
    if (!found) return; // it is asked for when the picture is at rest
    const std::int32_t chosen = found->hit ? std::int32_t(found->instance) : -1;
    state_.selected = chosen == state_.selected ? -1 : chosen;
    changed(false);
}

void ViewSession::scroll(double steps)
{
    if (steps == 0) return;
    const glm::dvec2 middle(width_ / 2.0, height_ / 2.0);
    const std::optional<Pick> under = latest_pick(); // at rest
    if (under && under->hit) mover().focus(double(under->t), seen_box_);
    mover().zoom(
        std::pow(kZoomStep, std::clamp(steps, -20.0, 20.0)), (pointer_ - middle) / double(height_));
    picks_ = false;
    changed(true);
}

void ViewSession::named_view(NamedView view)
{
    const Framing framing = firsthit::named_view(view, scene_->up_axis());
    mover().frame(seen_box_, framing.towards_eye, framing.up, double(width_) / height_);
    changed(true);
}

void ViewSession::frame_all()
{
    mover().frame(seen_box_, double(width_) / height_);
    changed(true);
}

void ViewSession::frame_selected()
{
    const std::shared_ptr<const ShownFrame> frame = latest();
    if (frame && frame->selected && frame->request.state.selected == state_.selected) {
        mover().frame(*frame->selected, double(width_) / height_);
        changed(true);
    } else {
        frame_all();
    }
}

void ViewSession::step(int frames)
{
    const std::int32_t clip = state_.clip;
    const double length = scene_->end_s(clip) - scene_->begin_s(clip);
    if (!(length > 0)) return;
    const int asked = scene_->first().frames(clip);
    const double step_s = asked > 1 ? length / (asked - 1) : 1.0 / 24;
    state_.playing = false;
    state_.time_s += frames * step_s;
    clamp_time();
    changed(false);
}

void ViewSession::choose_next(const char* name, int by)
{
    const Switch& chosen = switch_named(name);
    const auto count = int(chosen.words.size());
    int at = 0;
    while (at < count && chosen.words[std::size_t(at)] != chosen.get(state_)) ++at;
    choose_switch(name, chosen.words[std::size_t((at + by + count) % count)]);
}

void ViewSession::release_all()
{
    keys_.clear();
    held_.reset();
}

bool ViewSession::key(const std::string& name, bool down)
{
    if (!down) {
        keys_.erase(name);
        return false;
    }
    static const std::set<std::string> kFlying{"w", "a", "s", "d", "q", "e"};
    if (kFlying.contains(name)) {
        keys_.insert(name);
        return true;
    }
    try {
        return press(name);
    } catch (const std::exception& error) {
        complain(error.what());
        return true;
    }
}

bool ViewSession::press(const std::string& name)
{
    const auto toggle = [&](const char* chosen) {
        choose_switch(chosen, switch_named(chosen).get(state_) == "on" ? "off" : "on");
    };
    if (name == "space")
        toggle("play");
    else if (name == ".")
        step(1);
    else if (name == ",")
        step(-1);
    else if (name == "l")
        toggle("loop");
    else if (name == "[")
        choose_switch("speed", fmt::format("{}", std::max(-64.0, state_.speed / 2)));
    else if (name == "]")
        choose_switch("speed", fmt::format("{}", std::min(64.0, state_.speed * 2)));
    else if (name == "home")
        mover_.reset(), changed(false);
    else if (name == "f")
        frame_selected();
    else if (name == "shift+f")
        frame_all();
    else if (name == "1")
        named_view(NamedView::front);
    else if (name == "shift+1")
        named_view(NamedView::back);
    else if (name == "3")
        named_view(NamedView::right);
    else if (name == "shift+3")
        named_view(NamedView::left);
    else if (name == "7")
        named_view(NamedView::top);
    else if (name == "shift+7")
        named_view(NamedView::bottom);
    else if (name == "0")
        named_view(NamedView::iso);
    else if (name == "left")
        mover().orbit(-kArrowRad, 0), changed(true);
    else if (name == "right")
        mover().orbit(kArrowRad, 0), changed(true);
    else if (name == "up")
        mover().orbit(0, kArrowRad), changed(true);
    else if (name == "down")
        mover().orbit(0, -kArrowRad), changed(true);
    else if (name == "+" || name == "=")
        scroll(1);
    else if (name == "-")
        scroll(-1);
    else if (name == "t")
        toggle("turntable");
    else if (name == "pagedown" || name == "pageup") {
        const int count = int(std::max<std::size_t>(1, scene_->first().cameras.size()));
        const int next = (state_.camera + (name == "pagedown" ? 1 : count - 1)) % count;
        choose_switch("camera", fmt::format("{}", next));
    } else if (name == "v")
        choose_next("look", 1);
    else if (name == "shift+v")
        choose_next("look", -1);
    else if (name == "g")
        choose_next("engine", 1);
    else if (name == "h")
        choose_next("shadows", 1);
    else if (name == "tab")
        toggle("panel");
    else if (name == "b")
        toggle("bars");
    else if (name == "i")
        toggle("hover");
    else if (name == "?" || name == "f1")
        toggle("help");
    else if (name == "c") {
        copied_ = camera_options();
        say("copied: " + *copied_);
    } else if (name == "r" || name == "f5")
        reload();
    else if (name == "f12") {
        save_picture();
    } else if (name == "shift+f12") {
        record_or_stop();
    } else if (name == "escape") {
        if (!message_.text.empty() && message_.until == Clock::time_point::max())
            message_.text.clear();
        else if (state_.help)
            toggle("help");
        else if (state_.selected >= 0)
            choose_switch("selected", "-1");
        else
            wants_end_ = true;
    } else {
        return false;
    }
    return true;
}

} // namespace firsthit::cli::view
