// client_message.h - what a page says: a line of JSON a message.
#pragma once

#include "view/session/view_session.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace firsthit::cli::view {

struct MoveMessage {
    double x = 0, y = 0; // pixels of the picture
};
struct ButtonMessage {
    Button button = Button::left;
    bool down = false, shift = false;
};
struct ScrollMessage {
    double steps = 0;
};
struct KeyMessage {
    std::string name;
    bool down = false;
};
struct ReleaseMessage {}; // all keys and buttons of this page
struct ChooseMessage {
    std::string name, value;
};
struct ResizeMessage {
    int width = 0, height = 0;
};
struct SeenMessage {
    std::uint64_t number = 0; // of a picture that has arrived and was shown
};

using ClientMessage = std::variant<MoveMessage, ButtonMessage, ScrollMessage, KeyMessage,
    ReleaseMessage, ChooseMessage, ResizeMessage, SeenMessage>;

/// The longest message that is accepted, bytes.
inline constexpr std::size_t kMostMessage = 1024;
/// The largest picture that a page may ask for, pixels a side.
inline constexpr int kMostSide = 4096;

/// Reads one of
///     {"do": "move", "x": X, "y": Y}                  {"do": "scroll", "steps": N}
///     {"do": "button", "button": "left|middle|right", "down": true|false, "shift": true|false}
///     {"do": "key", "name": NAME, "down": true|false} {"do": "release"}
///     {"do": "choose", "switch": NAME, "value": TEXT} {"do": "resize", "width": W, "height": H}
///     {"do": "seen", "number": N}
/// throws  UsageError: anything else
ClientMessage parse_client_message(std::string_view text);

} // namespace firsthit::cli::view
