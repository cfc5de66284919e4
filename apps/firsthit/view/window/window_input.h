// window_input.h - takes input of a window, or of a script in its place, to the panels or to the session.
#pragma once

#include "view/script/script_player.h"

#include <functional>
#include <string>

namespace firsthit::cli::view {

/// Places are in the window's units, which on a dense screen are several pixels.
class WindowInput : public InputTarget {
  public:
    explicit WindowInput(ViewSession& session) : session_(session) {}

    void pointer_moves(double x, double y) override;
    void button(Button button, bool down, bool shift) override;
    void scroll(double steps) override;
    void key(const std::string& name, bool down) override;
    void resize(int width, int height) override { resize_(width, height); }
    void screenshot(const std::string& path) override { screenshot_(path); }
    /// A letter that is typed into a field of a panel.
    void letter(unsigned code);

    /// Pixels in a unit of the window.
    void set_scale(double scale) { scale_ = scale; }
    void set_window(
        std::function<void(int, int)> resize, std::function<void(const std::string&)> screenshot)
    {
        resize_ = std::move(resize);
        screenshot_ = std::move(screenshot);
    }

  private:
    ViewSession& session_;
    double scale_ = 1;
    bool session_holds_ = false; // a button that was pressed on the picture
    std::function<void(int, int)> resize_;
    std::function<void(const std::string&)> screenshot_;
};

/// Tells ImGui which of our keys are its own.
void name_imgui_keys();

/// "a", "shift+f", "space": the session's name of a key of GLFW with its modifiers; empty: none.
std::string key_name(int glfw_key, int modifiers);

} // namespace firsthit::cli::view
