// script.h - actions that drive a session in the place of a hand.
#pragma once

#include "view/session/view_session.h"

#include <string>
#include <variant>
#include <vector>

namespace firsthit::cli::view {

struct KeyAction {
    std::string name;
    double held_s = 0; // how long it is held
};
struct PointerAction {
    double x = 0, y = 0;
};
struct ClickAction {
    PointerAction at{};
    Button button = Button::left;
};
struct DragAction {
    PointerAction from{}, to{};
    Button button = Button::left;
    bool shift = false;
    int steps = 10; // movements on the way, one a frame
};
struct ScrollAction {
    PointerAction at{};
    double steps = 0;
};
struct WaitAction {
    enum class For { rest, frames, seconds, pick } what = For::rest;
    double count = 0;
};
struct ChooseAction {
    std::string name, value;
};
struct AssertAction {
    std::string name, value;
    bool negated = false;
};
struct ResizeAction {
    int width = 0, height = 0;
};
struct FileAction {
    enum class What { screenshot, picture, open } what = What::screenshot;
    std::string path;
};
struct MeasureAction {};
struct RenewAction {};
struct QuitAction {};

/// One line of a script.
struct Action {
    int line = 0;
    std::variant<KeyAction, PointerAction, ClickAction, DragAction, ScrollAction, WaitAction,
        ChooseAction, AssertAction, ResizeAction, FileAction, MeasureAction, RenewAction,
        QuitAction>
        what;
};

/// Reads a script: an action a line, # begins a comment.
///
///     key NAME [SECONDS]      mouse X Y             click X Y [left|middle|right]
///     drag X Y X Y [left|middle|right|shift] [STEPS]  scroll X Y STEPS
///     wait rest | wait N frames | wait N seconds | wait pick
///     choose SWITCH VALUE     assert SWITCH VALUE   refute SWITCH VALUE
///     screenshot FILE         picture FILE          open FILE
///     resize W H              measure               renew                quit
///
/// name    of the script, for messages
/// throws  UsageError: the script's name, the line, and what is accepted
std::vector<Action> parse_script(const std::string& text, const std::string& name);

/// The text of a file. throws  FileError
std::string read_text(const std::string& path);

} // namespace firsthit::cli::view
