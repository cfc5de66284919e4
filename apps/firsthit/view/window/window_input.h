// window_input.h - takes input of a window, or of a script in its place, to the panels or to the session.
#pragma once

#include "view/script/script_player.h"

#include <deque>
#include <functional>
#include <string>
#include <utility>

namespace firsthit::cli::view {

/// Places are in the window's units, which on a dense screen are several pixels.
class WindowInput : public InputTarget {
  public:
    explicit WindowInput(ViewSession& session) : session_(session) {}

    void pointer_moves(double x, double y) override;
    void button(Button button, bool down, bool shift) override;
    void scroll(double steps) override;
    void key(const std::string& name, bool down) override;
    void resize(int width, int height) override { window_.resize(width, height); }
    void screenshot(const std::string& path) override { window_.screenshot(path); }
    void renew() override { window_.renew(); }
    /// A character that is typed: into a field of a panel, or as a key of the session that is known by its sign,
    /// wherever the keyboard has it.
    void letter(unsigned code);
    /// Panels were drawn, and know what the pointer is over and which field takes letters: what waited for that is
    /// done.
    void panels_are_drawn();
    /// Whether input waits for panels to be drawn.
    bool waits() const { return !waiting_.empty(); }

    /// Pixels in a unit of the window.
    void set_scale(double scale) { scale_ = scale; }
    /// What is done to the window itself.
    struct OfWindow {
        std::function<void(int, int)> resize{};
        std::function<void(const std::string&)> screenshot{};
        std::function<void()> renew{};
    };
    void set_window(OfWindow window) { window_ = std::move(window); }

  private:
    /// Does something now, or when panels are drawn: a press belongs to what lies under the place that the pointer
    /// has moved to, and a letter to the field that was pressed.
    void when_drawn(std::function<void()> act);
    void point();
    void press(Button button, bool down, bool shift);
    void take_key(const std::string& name, bool down);
    void take_letter(unsigned code);

    ViewSession& session_;
    std::deque<std::function<void()>> waiting_;
    int draws_ = 0; // of panels that are to come before they know of the last move or press
    double scale_ = 1;
    double x_ = -1, y_ = -1;     // of the pointer
    bool session_holds_ = false; // a button that was pressed on the picture
    OfWindow window_;
};

/// Tells ImGui which of our keys are its own.
void name_imgui_keys();

/// "a", "shift+f", "space": the session's name of a key of GLFW with its modifiers; empty: none.
std::string key_name(int glfw_key, int modifiers);

} // namespace firsthit::cli::view
