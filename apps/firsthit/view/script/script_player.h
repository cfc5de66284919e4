// script_player.h - plays a script, a step at a time, between the frames of a session.
#pragma once

#include "view/script/script.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Where a script's hand goes: to the window, whose panels may take it, or straight to a session.
class InputTarget {
  public:
    virtual ~InputTarget() = default;
    virtual void pointer_moves(double x, double y) = 0;
    virtual void button(Button button, bool down, bool shift) = 0;
    virtual void scroll(double steps) = 0;
    virtual void key(const std::string& name, bool down) = 0;
    virtual void resize(int width, int height) = 0;
    /// Writes what is on the screen.
    virtual void screenshot(const std::string& path) = 0;
    /// Makes the window and its OpenGL context again, as after a lost context.
    virtual void renew() = 0;
};

/// The target that is a session without a window; its screenshot is the picture with its look.
class SessionInput : public InputTarget {
  public:
    explicit SessionInput(ViewSession& session) : session_(session) {}
    void pointer_moves(double x, double y) override { session_.pointer_moves(x, y); }
    void button(Button button, bool down, bool shift) override
    {
        session_.button(button, down, shift);
    }
    void scroll(double steps) override { session_.scroll(steps); }
    void key(const std::string& name, bool down) override { session_.key(name, down); }
    void resize(int width, int height) override { session_.resize(width, height); }
    void screenshot(const std::string& path) override;
    void renew() override {}

  private:
    ViewSession& session_;
};

class ScriptPlayer {
  public:
    /// name  of the script, for messages
    ScriptPlayer(std::vector<Action> actions, std::string name);

    /// Does what can be done now; to be called once after each look for new frames.
    /// returns  whether the script has not ended
    /// throws   Error: an assertion that does not hold, a wait of more than a minute, a file, with name and
    ///          line; what the session throws
    bool step(ViewSession& session, InputTarget& target, Clock::time_point now);

    /// Whether the script said quit.
    bool quits() const { return quits_; }

  private:
    bool done(
        const Action& action, ViewSession& session, InputTarget& target, Clock::time_point now);
    bool waited(const WaitAction& wait, ViewSession& session, Clock::time_point now);
    bool dragged(const DragAction& drag, InputTarget& target);
    void check(const AssertAction& assertion, const ViewSession& session) const;

    std::vector<Action> actions_;
    std::string name_;
    std::size_t next_ = 0;
    bool quits_ = false;
    std::optional<Clock::time_point> since_; // of the action in work
    std::uint64_t frames_before_ = 0;
    int step_ = 0; // of an action that takes several
};

/// How long it took from input to the screen, in lines to read.
std::string measured(const ViewSession& session);

} // namespace firsthit::cli::view
