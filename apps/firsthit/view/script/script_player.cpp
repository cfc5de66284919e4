// script_player.cpp - plays a script, a step at a time.
#include "view/script/script_player.h"

#include "common/output.h"
#include "common/usage.h"
#include "view/frames/write_pixels.h"
#include "view/session/process_memory.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace firsthit::cli::view {
namespace {

/// A wait that takes longer has hung: a script is for tests.
constexpr std::chrono::seconds kMostWait{60};

constexpr std::chrono::seconds kMostResize{2};

template <class... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

} // namespace

void SessionInput::screenshot(const std::string& path)
{
    const std::shared_ptr<const ShownFrame> frame = session_.latest();
    if (!frame) throw UsageError(fmt::format("{}: there is no picture yet", path));
    write_pixels(frame->rgba, frame->width, frame->height, path);
}

ScriptPlayer::ScriptPlayer(std::vector<Action> actions, std::string name)
    : actions_(std::move(actions)),
      name_(std::move(name))
{
}

bool ScriptPlayer::step(ViewSession& session, InputTarget& target, Clock::time_point now)
{
    while (next_ < actions_.size() && !quits_) {
        const Action& action = actions_[next_];
        if (!since_) {
            since_ = now;
            frames_before_ = session.history().count();
            step_ = 0;
        }
        bool over = false;
        try {
            over = done(action, session, target, now);
        } catch (const std::exception& error) {
            throw Error(fmt::format("{}:{}: {}", name_, action.line, error.what()));
        }
        if (!over) {
            if (now - *since_ > kMostWait)
                throw Error(fmt::format("{}:{}: waited for more than {} seconds{}", name_,
                    action.line, kMostWait.count(),
                    session.message().empty() ? "" : ": " + session.message()));
            return true;
        }
        since_.reset();
        ++next_;
        // What was done is to be seen before the next action: the frame after it is asked for first.
        session.update(now);
        const bool waits =
            next_ < actions_.size() && std::holds_alternative<WaitAction>(actions_[next_].what);
        if (!waits) return next_ < actions_.size();
    }
    return next_ < actions_.size() && !quits_;
}

bool ScriptPlayer::waited(const WaitAction& wait, ViewSession& session, Clock::time_point now)
{
    switch (wait.what) {
    case WaitAction::For::rest:
        if (session.has_failed()) throw Error(session.message());
        return session.is_at_rest(now);
    case WaitAction::For::pick:
        return session.latest_pick().has_value();
    case WaitAction::For::frames:
        if (session.is_at_rest(now)) ++step_; // no new pictures come, but the window is drawn
        return double(session.history().count() - frames_before_) + step_ >= wait.count;
    case WaitAction::For::seconds:
        return std::chrono::duration<double>(now - *since_).count() >= wait.count;
    }
    return true;
}

bool ScriptPlayer::dragged(const DragAction& drag, InputTarget& target)
{
    // A window looks at its pointer once a frame: it comes, then presses, then moves.
    constexpr int kPress = 2;
    const int moved = step_ - kPress;
    if (step_ == 0) {
        target.pointer_moves(drag.from.x, drag.from.y);
    } else if (moved == 0) {
        target.button(drag.button, true, drag.shift);
    } else if (moved > drag.steps) {
        target.button(drag.button, false, drag.shift);
        return true;
    } else if (moved > 0) {
        const double share = double(moved) / drag.steps;
        target.pointer_moves(
            std::lerp(drag.from.x, drag.to.x, share), std::lerp(drag.from.y, drag.to.y, share));
    }
    ++step_;
    return false;
}

void ScriptPlayer::check(const AssertAction& assertion, const ViewSession& session) const
{
    const Switch& named = switch_named(assertion.name);
    const std::string value = named.get(session.state());
    if (same_value(named, value, assertion.value) == assertion.negated)
        throw Error(fmt::format("{} is {}, {} {}", assertion.name, value,
            assertion.negated ? "which is not to be" : "not", assertion.value));
}

bool ScriptPlayer::done(
    const Action& action, ViewSession& session, InputTarget& target, Clock::time_point now)
{
    return std::visit(
        Overloaded{
            [&](const KeyAction& key) {
                if (step_ == 0) target.key(key.name, true);
                step_ = 1;
                if (std::chrono::duration<double>(now - *since_).count() < key.held_s) return false;
                target.key(key.name, false);
                return true;
            },
            [&](const PointerAction& at) {
                target.pointer_moves(at.x, at.y);
                return true;
            },
            [&](const ClickAction& click) { // a window looks at its pointer once a frame
                if (step_ == 0) target.pointer_moves(click.at.x, click.at.y);
                if (step_ == 2) target.button(click.button, true, false);
                if (step_ == 4) target.button(click.button, false, false);
                return step_++ >= 6;
            },
            [&](const DragAction& drag) { return dragged(drag, target); },
            [&](const ScrollAction& scroll) {
                if (step_ == 0) target.pointer_moves(scroll.at.x, scroll.at.y);
                if (step_ == 2) target.scroll(scroll.steps);
                return step_++ >= 3;
            },
            [&](const WaitAction& wait) { return waited(wait, session, now); },
            [&](const ChooseAction& chosen) {
                session.choose_switch(chosen.name, chosen.value);
                return true;
            },
            [&](const AssertAction& assertion) {
                check(assertion, session);
                return true;
            },
            [&](const ResizeAction& size) {
                // A window has its new size some time after it was asked for; a screen may also not allow it.
                if (step_++ == 0) target.resize(size.width, size.height);
                return (session.width() == size.width && session.height() == size.height) ||
                       now - *since_ > kMostResize;
            },
            [&](const FileAction& file) {
                if (file.what == FileAction::What::open) session.open(file.path);
                if (file.what == FileAction::What::picture)
                    session.write_picture_at_rest(file.path);
                if (file.what == FileAction::What::screenshot) target.screenshot(file.path);
                return true;
            },
            [&](const MeasureAction&) {
                if (step_ == 0) print(measured(session));
                session.history().restart();
                return true;
            },
            [&](const RenewAction&) {
                target.renew();
                return true;
            },
            [&](const QuitAction&) {
                quits_ = true;
                return true;
            },
        },
        action.what);
}

std::string measured(const ViewSession& session)
{
    const FrameHistory& history = session.history();
    const std::vector<double>& ms = history.latencies_ms();
    std::vector<double> made;
    for (const HistoryEntry& frame : history.frames()) made.push_back(frame.made_ms);
    return fmt::format("{} frames, {:.1f} a second over the last, {:.1f} at the slowest hundredth; "
                       "longest gap {:.1f} ms\n"
                       "input to screen, {} events: median {:.1f} ms, 99 % {:.1f} ms\n"
                       "making a frame: median {:.1f} ms; given up: {}\n"
                       "input waited at most {:.1f} ms; memory {:.1f} MB\n",
        history.count(),
        history.rate(history.frames().empty() ? Clock::now() : history.frames().back().shown),
        history.low_rate(), history.longest_gap_ms(), ms.size(), quantile(ms, 0.5),
        quantile(ms, 0.99), quantile(made, 0.5), session.cancelled(), history.longest_turn_ms(),
        memory_mb());
}

} // namespace firsthit::cli::view
