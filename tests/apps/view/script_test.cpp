// script_test.cpp - scripts of actions: what they say, and what is wrong with them.
#include "view/script/script.h"
#include "view/session/switches.h"

#include "common/usage.h"
#include "message_of.h"

#include <gtest/gtest.h>

namespace firsthit::cli::view {
namespace {

std::string error_of(const std::string& text)
{
    return message_of<UsageError>([&] { (void)parse_script(text, "a.txt"); });
}

TEST(Script, ReadsAllActions)
{
    const auto actions = parse_script(
        "# a comment\n\nkey w 0.5\nmouse 3 4\nclick 5 6 right # here\ndrag 1 2 3 4 shift 20\n"
        "scroll 1 2 -3\nwait rest\nwait 3 frames\nwait 0.5 seconds\nwait pick\n"
        "choose engine hybrid\nassert engine hybrid\nrefute play on\nresize 640 480\n"
        "screenshot a.png\npicture b.png\nopen c.stl\nmeasure\nquit\n",
        "a.txt");
    ASSERT_EQ(actions.size(), 18u);
    EXPECT_EQ(actions[0].line, 3);
    EXPECT_EQ(std::get<KeyAction>(actions[0].what).held_s, 0.5);
    EXPECT_EQ(std::get<ClickAction>(actions[2].what).button, Button::right);
    const auto& drag = std::get<DragAction>(actions[3].what);
    EXPECT_TRUE(drag.shift);
    EXPECT_EQ(drag.steps, 20);
    EXPECT_EQ(drag.to.y, 4);
    EXPECT_TRUE(std::get<AssertAction>(actions[11].what).negated);
}

TEST(Script, ErrorsNameFileAndLine)
{
    EXPECT_EQ(error_of("wait rest\njump\n").substr(0, 30), "a.txt:2: 'jump' is no action: ");
    EXPECT_EQ(error_of("key"), "a.txt:1: 'key' lacks the key's name");
    EXPECT_NE(error_of("mouse 1 x").find("a.txt:1: 'x'"), std::string::npos);
    EXPECT_EQ(error_of("quit now"), "a.txt:1: 'now' is one word too many");
    EXPECT_NE(error_of("wait 3 days").find("'3 days' is nothing to wait for"), std::string::npos);
    EXPECT_NE(error_of("wait for it").find("'for' is nothing to wait for"), std::string::npos);
    EXPECT_NE(error_of("click 1 2 up").find("'up' is no button"), std::string::npos);
    EXPECT_NE(error_of("resize 0 5").find("accepted are sizes"), std::string::npos);
}

TEST(Script, ErrorsOfSwitchesSayWhatIsAccepted)
{
    EXPECT_NE(error_of("choose motor cpu")
                  .find("a.txt:1: there is no switch 'motor': accepted are look, "),
        std::string::npos);
    EXPECT_EQ(error_of("choose engine steam"),
        "a.txt:1: engine: 'steam' is not accepted: accepted are cpu, hybrid, gpu, auto");
    EXPECT_EQ(error_of("choose samples 17"),
        "a.txt:1: samples: '17' is not accepted: accepted are whole numbers 1 to 16");
    EXPECT_EQ(error_of("assert samples 1.5"),
        "a.txt:1: samples: '1.5' is not accepted: accepted are whole numbers 1 to 16");
}

TEST(Switches, GiveBackWhatWasChosen)
{
    for (const Switch& one : all_switches()) {
        ViewState state;
        if (one.words.empty()) {
            for (const double value : {one.least, one.most}) {
                if (one.name == "shadow-map-size" && value > 0 && value < 16) continue;
                choose(one, std::to_string(value), state);
                EXPECT_TRUE(same_value(one, one.get(state), std::to_string(value))) << one.name;
            }
        }
        for (const std::string& word : one.words) {
            choose(one, word, state);
            EXPECT_EQ(one.get(state), word) << one.name;
        }
    }
}

TEST(Switches, EachChangesTheState)
{
    for (const Switch& one : all_switches()) {
        ViewState state;
        const std::string before = one.get(state);
        if (one.words.empty()) {
            const double other = parse_number(before) == one.most ? one.least : one.most;
            choose(one, std::to_string(other), state);
        } else {
            choose(one, one.words[0] == before ? one.words[1] : one.words[0], state);
        }
        EXPECT_NE(one.get(state), before) << one.name;
        EXPECT_FALSE(one.text.empty()) << one.name;
    }
}

} // namespace
} // namespace firsthit::cli::view
