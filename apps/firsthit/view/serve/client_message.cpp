// client_message.cpp - what a page says: a line of JSON a message.
#include "view/serve/client_message.h"

#include "common/usage.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace firsthit::cli::view {
namespace {

/// Places beyond this are of no picture.
constexpr double kMostPlace = 1e6;
constexpr double kMostSteps = 100;
constexpr std::size_t kMostName = 64;

using Json = nlohmann::json;

[[noreturn]] void refuse_message(const std::string& why)
{
    throw UsageError("the page's message is refused: " + why);
}

const Json& field(const Json& message, const char* name)
{
    const auto found = message.find(name);
    if (found == message.end()) refuse_message(fmt::format("it lacks '{}'", name));
    return *found;
}

double number_in(const Json& message, const char* name, double least, double most)
{
    const Json& value = field(message, name);
    if (!value.is_number()) refuse_message(fmt::format("'{}' is no number", name));
    const double number = value.get<double>();
    if (!(least <= number && number <= most))
        refuse_message(fmt::format("'{}' is not from {} to {}", name, least, most));
    return number;
}

int whole_in(const Json& message, const char* name, int least, int most)
{
    const double number = number_in(message, name, least, most);
    if (number != std::floor(number)) refuse_message(fmt::format("'{}' is not whole", name));
    return static_cast<int>(number);
}

bool truth_of(const Json& message, const char* name)
{
    const Json& value = field(message, name);
    if (!value.is_boolean()) refuse_message(fmt::format("'{}' is not true or false", name));
    return value.get<bool>();
}

std::string text_of(const Json& message, const char* name)
{
    const Json& value = field(message, name);
    if (!value.is_string()) refuse_message(fmt::format("'{}' is no text", name));
    std::string text = value.get<std::string>();
    if (text.size() > kMostName) refuse_message(fmt::format("'{}' is too long", name));
    return text;
}

ButtonMessage button_of(const Json& message)
{
    ButtonMessage button{.down = truth_of(message, "down"), .shift = truth_of(message, "shift")};
    const std::string name = text_of(message, "button");
    if (name == "right")
        button.button = Button::right;
    else if (name == "middle")
        button.button = Button::middle;
    else if (name != "left")
        refuse_message("'button' is not left, middle or right");
    return button;
}

std::uint64_t count_of(const Json& message, const char* name)
{
    const Json& value = field(message, name);
    if (!value.is_number_unsigned()) refuse_message(fmt::format("'{}' is no count", name));
    return value.get<std::uint64_t>();
}

} // namespace

ClientMessage parse_client_message(std::string_view text)
{
    if (text.size() > kMostMessage) refuse_message("it is too long");
    const Json message = Json::parse(text, nullptr, false);
    if (!message.is_object()) refuse_message("it is no JSON object");
    const std::string what = text_of(message, "do");
    if (what == "move")
        return MoveMessage{number_in(message, "x", -kMostPlace, kMostPlace),
            number_in(message, "y", -kMostPlace, kMostPlace)};
    if (what == "button") return button_of(message);
    if (what == "scroll")
        return ScrollMessage{number_in(message, "steps", -kMostSteps, kMostSteps)};
    if (what == "key") return KeyMessage{text_of(message, "name"), truth_of(message, "down")};
    if (what == "release") return ReleaseMessage{};
    if (what == "choose")
        return ChooseMessage{text_of(message, "switch"), text_of(message, "value")};
    if (what == "resize")
        return ResizeMessage{
            whole_in(message, "width", 1, kMostSide), whole_in(message, "height", 1, kMostSide)};
    if (what == "seen") return SeenMessage{count_of(message, "number")};
    refuse_message("'do' is unknown");
}

} // namespace firsthit::cli::view
