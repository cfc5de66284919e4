// window_input.h - takes input of a window, or of a script in its place, to the panels or to the session.
#pragma once

#include "view/script/script_player.h"

#include <functional>
#include <string>
#include <utility>

namespace firsthit::cli::view {

/// Places are in the window's units, which on a dense screen are several pixels.
class WindowInput : public InputTarget {
  public:
    explicit WindowInput(ViewSession& session) : session_(session) {}

    void pointer_moves(double x, double y) override;
    /// Gives the pointer to the panel or the picture that it is over. To be called after panels are drawn.
    void point();
    void button(Button button, bool down, bool shift) override;
    void scroll(double steps) override;
    void key(const std::string& name, bool down) override;
    void resize(int width, int height) override { window_.resize(width, height); }
    void screenshot(const std::string& path) override { window_.screenshot(path); }
    void renew() override { window_.renew(); }
    /// A character that is typed: into a field of a panel, or as a key of the session that is known by its sign,
    /// wherever the keyboard has it.
    void letter(unsigned code);

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
    ViewSession& session_;
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
