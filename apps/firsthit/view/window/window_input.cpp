// window_input.cpp - takes input of a window to the panels or to the session.
#include "view/window/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace firsthit::cli::view {
namespace {

/// Keys with names; letters and digits are their own. Those that type another sign are in kSigns.
constexpr auto kKeys =
    std::to_array<std::pair<int, const char*>>({{GLFW_KEY_SPACE, "space"}, {GLFW_KEY_HOME, "home"},
        {GLFW_KEY_END, "end"}, {GLFW_KEY_PAGE_UP, "pageup"}, {GLFW_KEY_PAGE_DOWN, "pagedown"},
        {GLFW_KEY_LEFT, "left"}, {GLFW_KEY_RIGHT, "right"}, {GLFW_KEY_UP, "up"},
        {GLFW_KEY_DOWN, "down"}, {GLFW_KEY_TAB, "tab"}, {GLFW_KEY_F1, "f1"}, {GLFW_KEY_F5, "f5"},
        {GLFW_KEY_F12, "f12"}, {GLFW_KEY_ESCAPE, "escape"}, {GLFW_KEY_BACKSPACE, "backspace"},
        {GLFW_KEY_DELETE, "delete"}, {GLFW_KEY_ENTER, "enter"}, {GLFW_KEY_KP_ENTER, "enter"}});

/// ImGui knows what is under the pointer when panels are drawn, and which field takes letters a draw later.
constexpr int kDrawsOfMove = 1, kDrawsOfPress = 2;

/// Keys of the session that are known by the sign that they type.
constexpr std::string_view kSigns = "?+-=.,[]";

/// Keys that fields of panels need.
constexpr auto kFieldKeys = std::to_array<std::pair<ImGuiKey, const char*>>(
    {{ImGuiKey_LeftArrow, "left"}, {ImGuiKey_RightArrow, "right"}, {ImGuiKey_Home, "home"},
        {ImGuiKey_Backspace, "backspace"}, {ImGuiKey_Delete, "delete"}, {ImGuiKey_Enter, "enter"},
        {ImGuiKey_Escape, "escape"}, {ImGuiKey_Tab, "tab"}, {ImGuiKey_End, "end"}});

int field_key(const std::string& name)
{
    for (std::size_t k = 0; k < kFieldKeys.size(); ++k)
        if (name == kFieldKeys[k].second) return int(k);
    return -1;
}

} // namespace

void name_imgui_keys()
{
    for (std::size_t k = 0; k < kFieldKeys.size(); ++k)
        ImGui::GetIO().KeyMap[kFieldKeys[k].first] = int(k);
}

std::string key_name(int glfw_key, int modifiers)
{
    if (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER)) return {};
    const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    std::string name;
    if (GLFW_KEY_A <= glfw_key && glfw_key <= GLFW_KEY_Z)
        name = std::string(1, char('a' + (glfw_key - GLFW_KEY_A)));
    else if (GLFW_KEY_0 <= glfw_key && glfw_key <= GLFW_KEY_9)
        name = std::string(1, char('0' + (glfw_key - GLFW_KEY_0)));
    else if (GLFW_KEY_KP_0 <= glfw_key && glfw_key <= GLFW_KEY_KP_9)
        name = std::string(1, char('0' + (glfw_key - GLFW_KEY_KP_0)));
    for (const auto& [key, text] : kKeys)
        if (key == glfw_key) name = text;
    return shift && !name.empty() ? "shift+" + name : name;
}

void WindowInput::when_drawn(std::function<void()> act)
{
    if (draws_ == 0 && waiting_.empty())
        act();
    else
        waiting_.push_back(std::move(act));
}

void WindowInput::panels_are_drawn()
{
    if (draws_ > 0) --draws_;
    point();
    while (draws_ == 0 && !waiting_.empty()) {
        const std::function<void()> act = std::move(waiting_.front());
        waiting_.pop_front();
        act();
    }
}

void WindowInput::pointer_moves(double x, double y)
{
    const auto move = [this, x, y] {
        ImGui::GetIO().MousePos = {float(x), float(y)};
        x_ = x;
        y_ = y;
        if (!session_holds_) draws_ = std::max(draws_, kDrawsOfMove); // a drag goes on anywhere
        point();
    };
    if (waiting_.empty())
        move(); // the picture follows at once
    else
        when_drawn(move);
}

void WindowInput::point()
{
    // Whether the pointer is over a panel is what the panels said when they were drawn last.
    if (ImGui::GetIO().WantCaptureMouse && !session_holds_)
        session_.pointer_moves(-1, -1);
    else
        session_.pointer_moves(x_ * scale_, y_ * scale_);
}

void WindowInput::button(Button button, bool down, bool shift)
{
    when_drawn([this, button, down, shift] { press(button, down, shift); });
}

void WindowInput::press(Button button, bool down, bool shift)
{
    draws_ = kDrawsOfPress;
    ImGuiIO& io = ImGui::GetIO();
    const int number = button == Button::left ? 0 : button == Button::right ? 1 : 2;
    if (down && io.WantCaptureMouse) {
        io.MouseDown[number] = true;
        return;
    }
    io.MouseDown[number] = down; // beside the panels: a field gives up the keyboard
    session_holds_ = down;
    session_.button(button, down, shift);
}

void WindowInput::scroll(double steps)
{
    ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse)
        io.MouseWheel += float(steps);
    else
        session_.scroll(steps);
}

void WindowInput::key(const std::string& name, bool down)
{
    when_drawn([this, name, down] { take_key(name, down); });
}

void WindowInput::take_key(const std::string& name, bool down)
{
    ImGuiIO& io = ImGui::GetIO();
    const int field = field_key(name);
    if (field >= 0) {
        io.KeysDown[field] = down && io.WantTextInput;
        draws_ = std::max(draws_, kDrawsOfMove); // or a key that is let go at once is never seen
    }
    if (down && io.WantTextInput) return;
    session_.key(name, down);
    // A key that was pressed with shift may be let go without it.
    if (!down && name.starts_with("shift+")) session_.key(name.substr(6), false);
}

void WindowInput::letter(unsigned code)
{
    when_drawn([this, code] { take_letter(code); });
}

void WindowInput::take_letter(unsigned code)
{
    if (ImGui::GetIO().WantTextInput) {
        ImGui::GetIO().AddInputCharacter(code);
        return;
    }
    if (code > 127 || kSigns.find(char(code)) == std::string_view::npos) return;
    const std::string name(1, char(code));
    session_.key(name, true);
    session_.key(name, false);
}

} // namespace firsthit::cli::view
