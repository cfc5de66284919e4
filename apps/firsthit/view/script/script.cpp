// script.cpp - reads scripts of actions.
#include "view/script/script.h"

#include "common/parse.h"
#include "common/usage.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace firsthit::cli::view {
namespace {

constexpr const char* kActions =
    "key, mouse, click, drag, scroll, wait, choose, assert, refute, screenshot, picture, open, "
    "resize, measure, renew and quit";

/// The words of a line, and where it stands. All throw UsageError that says so.
class Line {
  public:
    Line(const std::string& text, std::string place) : place_(std::move(place))
    {
        std::istringstream stream(text.substr(0, text.find('#')));
        for (std::string word; stream >> word;) words_.push_back(word);
    }

    bool empty() const { return words_.empty(); }
    const std::string& action() const { return words_[0]; }
    bool has_more() const { return next_ < words_.size(); }

    std::string word(const char* what)
    {
        if (!has_more()) fail(fmt::format("'{}' lacks {}", action(), what));
        return words_[next_++];
    }

    double number(const char* what)
    {
        const std::string text = word(what);
        try {
            return parse_number(text);
        } catch (const UsageError& error) {
            fail(error.what());
        }
    }

    void end()
    {
        if (has_more()) fail(fmt::format("'{}' is one word too many", words_[next_]));
    }

    [[noreturn]] void fail(const std::string& why) const
    {
        throw UsageError(fmt::format("{}: {}", place_, why));
    }

  private:
    std::string place_;
    std::vector<std::string> words_;
    std::size_t next_ = 1;
};

PointerAction pointer_of(Line& line)
{
    const double x = line.number("x, in pixels from the left");
    return {x, line.number("y, in pixels from the top")};
}

Button button_of(Line& line, const std::string& text)
{
    if (text == "left") return Button::left;
    if (text == "middle") return Button::middle;
    if (text == "right") return Button::right;
    line.fail(fmt::format("'{}' is no button: accepted are left, middle and right", text));
}

DragAction drag_of(Line& line)
{
    DragAction drag{.from = pointer_of(line)};
    drag.to = pointer_of(line);
    while (line.has_more()) {
        const std::string text = line.word("a button");
        if (text == "shift") {
            drag.shift = true;
        } else if (text.find_first_not_of("0123456789") == std::string::npos) {
            try {
                drag.steps = parse_integer(text, 1, 10000);
            } catch (const UsageError& error) {
                line.fail(error.what());
            }
        } else {
            drag.button = button_of(line, text);
        }
    }
    return drag;
}

WaitAction wait_of(Line& line)
{
    constexpr const char* kAccepted =
        "accepted are: wait rest, wait pick, wait N frames and wait N seconds";
    const std::string text = line.word("what for");
    if (text == "rest") return {WaitAction::For::rest, 0};
    if (text == "pick") return {WaitAction::For::pick, 0};
    double count = 0;
    try {
        count = parse_number(text);
    } catch (const UsageError&) {
        line.fail(fmt::format("'{}' is nothing to wait for; {}", text, kAccepted));
    }
    const std::string unit = line.word("'frames' or 'seconds'");
    if (unit == "frames" && count >= 1) return {WaitAction::For::frames, count};
    if (unit == "seconds" && count >= 0) return {WaitAction::For::seconds, count};
    line.fail(fmt::format("'{} {}' is nothing to wait for; {}", text, unit, kAccepted));
}

/// The switch and value of choose and assert, which exist.
ChooseAction switch_of(Line& line)
{
    const std::string name = line.word("a switch");
    const ChooseAction chosen{name, line.word("a value")};
    try {
        ViewState unused;
        choose(switch_named(name), chosen.value, unused);
    } catch (const UsageError& error) {
        line.fail(error.what());
    }
    return chosen;
}

Action action_of(Line& line, int number)
{
    const std::string& action = line.action();
    if (action == "key") {
        KeyAction key{line.word("the key's name")};
        if (line.has_more()) key.held_s = line.number("seconds");
        return {number, key};
    }
    if (action == "mouse") return {number, pointer_of(line)};
    if (action == "click") {
        ClickAction click{.at = pointer_of(line)};
        if (line.has_more()) click.button = button_of(line, line.word("a button"));
        return {number, click};
    }
    if (action == "drag") return {number, drag_of(line)};
    if (action == "scroll") {
        ScrollAction scroll{.at = pointer_of(line)};
        scroll.steps = line.number("steps of the wheel");
        return {number, scroll};
    }
    if (action == "wait") return {number, wait_of(line)};
    if (action == "choose") return {number, switch_of(line)};
    if (action == "assert" || action == "refute") {
        const ChooseAction named = switch_of(line);
        return {number, AssertAction{named.name, named.value, action == "refute"}};
    }
    if (action == "resize") {
        const double width = line.number("the width"), height = line.number("the height");
        if (!(1 <= width && width <= 16384 && 1 <= height && height <= 16384))
            line.fail("accepted are sizes from 1 to 16384 pixels");
        return {number, ResizeAction{int(width), int(height)}};
    }
    using What = FileAction::What;
    if (action == "screenshot") return {number, FileAction{What::screenshot, line.word("a file")}};
    if (action == "picture") return {number, FileAction{What::picture, line.word("a file")}};
    if (action == "open") return {number, FileAction{What::open, line.word("a file")}};
    if (action == "measure") return {number, MeasureAction{}};
    if (action == "renew") return {number, RenewAction{}};
    if (action == "quit") return {number, QuitAction{}};
    line.fail(fmt::format("'{}' is no action: accepted are {}", action, kActions));
}

} // namespace

std::vector<Action> parse_script(const std::string& text, const std::string& name)
{
    std::vector<Action> actions;
    std::istringstream stream(text);
    int number = 0;
    for (std::string words; std::getline(stream, words);) {
        Line line(words, fmt::format("{}:{}", name, ++number));
        if (line.empty()) continue;
        actions.push_back(action_of(line, number));
        line.end();
    }
    return actions;
}

std::string read_text(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string text;
    if (!file) throw FileError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    try {
        text.assign(std::istreambuf_iterator<char>(file), {});
    } catch (const std::ios_base::failure& error) { // a folder, as one
        throw FileError(
            fmt::format("{}: cannot be read: {}", path, std::strerror(error.code().value())));
    }
    if (text.empty()) throw FileError(path + ": the file is empty");
    return text;
}

} // namespace firsthit::cli::view
