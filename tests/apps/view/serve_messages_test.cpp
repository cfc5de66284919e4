// serve_messages_test.cpp - what pages say and what they are told.
#include "view/serve/client_message.h"
#include "view/serve/session_messages.h"

#include "common/usage.h"
#include "apps/view/sessions.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

namespace firsthit::cli::view {
namespace {

bool is_refused(const std::string& text)
{
    try {
        (void)parse_client_message(text);
        return false;
    } catch (const UsageError&) {
        return true;
    }
}

TEST(ClientMessage, ReadsAllKinds)
{
    const auto move =
        std::get<MoveMessage>(parse_client_message(R"({"do":"move","x":1.5,"y":-2})"));
    EXPECT_EQ(move.x, 1.5);
    EXPECT_EQ(move.y, -2);
    const auto button = std::get<ButtonMessage>(
        parse_client_message(R"({"do":"button","button":"right","down":true,"shift":true})"));
    EXPECT_EQ(button.button, Button::right);
    EXPECT_TRUE(button.down && button.shift);
    const auto scroll =
        std::get<ScrollMessage>(parse_client_message(R"({"do":"scroll","steps":-3})"));
    EXPECT_EQ(scroll.steps, -3);
    const auto key =
        std::get<KeyMessage>(parse_client_message(R"({"do":"key","name":"shift+f","down":false})"));
    EXPECT_EQ(key.name, "shift+f");
    EXPECT_FALSE(key.down);
    EXPECT_TRUE(
        std::holds_alternative<ReleaseMessage>(parse_client_message(R"({"do":"release"})")));
    const auto chosen = std::get<ChooseMessage>(
        parse_client_message(R"({"do":"choose","switch":"look","value":"items"})"));
    EXPECT_EQ(chosen.name, "look");
    EXPECT_EQ(chosen.value, "items");
    const auto size = std::get<ResizeMessage>(
        parse_client_message(R"({"do":"resize","width":640,"height":480})"));
    EXPECT_EQ(size.width, 640);
    EXPECT_EQ(size.height, 480);
    EXPECT_EQ(
        std::get<SeenMessage>(parse_client_message(R"({"do":"seen","number":7})")).number, 7u);
}

TEST(ClientMessage, RefusesWhatNoPageSays)
{
    for (const char* text :
        {"", "{", "{}", "[]", "null", "1", "\"do\"", R"({"do":7})",
            R"({"do":"open","file":"/etc/passwd"})", R"({"do":"move","x":1})",
            R"({"do":"move","x":"1","y":1})", R"({"do":"move","x":1e999,"y":0})",
            R"({"do":"move","x":2e6,"y":0})", R"({"do":"move","x":null,"y":0})",
            R"({"do":"scroll","steps":101})", R"({"do":"scroll","steps":true})",
            R"({"do":"button","button":"x","down":true,"shift":false})",
            R"({"do":"button","button":"left","down":0,"shift":false})",
            R"({"do":"key","name":"a"})", R"({"do":"key","name":5,"down":true})",
            R"({"do":"resize","width":0,"height":5})", R"({"do":"resize","width":5,"height":4097})",
            R"({"do":"resize","width":5.5,"height":5})", R"({"do":"seen","number":-1})",
            R"({"do":"seen","number":1.5})", R"({"do":"choose","switch":"look"})", "\xff\xfe",
            R"({"do":"release"} x)"})
        EXPECT_TRUE(is_refused(text)) << text;
    EXPECT_TRUE(is_refused(R"({"do":"key","down":true,"name":")" + std::string(65, 'a') + "\"}"));
    EXPECT_TRUE(is_refused(std::string(kMostMessage, '[')));
    EXPECT_TRUE(is_refused(R"({"do":"release"})" + std::string(kMostMessage, ' ')));
}

TEST(ClientMessage, SurvivesChangedBytes)
{
    std::mt19937 random(5);
    const std::string whole = R"({"do":"button","button":"left","down":true,"shift":false})";
    int refused = 0;
    for (int k = 0; k < 20000; ++k) {
        std::string text = whole;
        for (unsigned n = 0; n <= random() % 3; ++n)
            text[random() % text.size()] = static_cast<char>(random());
        if (random() % 4 == 0) text.resize(random() % text.size());
        refused += is_refused(text) ? 1 : 0;
    }
    EXPECT_GT(refused, 15000);
    EXPECT_LT(refused,
        20000); // a changed "shift" is another key beside the one that lacks: some stay whole
}

TEST(SessionMessages, TellWhatThereIs)
{
    ViewSession session(options_of("builtin:robots"), [] {});
    session.resize(160, 120);
    ASSERT_TRUE(comes_to_rest(session));
    const auto told = nlohmann::json::parse(described(session));
    EXPECT_EQ(told["kind"], "session");
    std::size_t of_window = 0;
    for (const Switch& one : all_switches()) of_window += one.group == "window" ? 1 : 0;
    EXPECT_EQ(told["switches"].size() + of_window, all_switches().size());
    for (const auto& one : told["switches"]) {
        EXPECT_EQ(one["values"].size(), one["shown"].size()) << one;
        if (one["name"] != "clip") continue;
        EXPECT_EQ(one["values"].size(), 2u) << one; // at rest, and one
    }
    for (const auto& line : told["keys"]) EXPECT_EQ(line.size(), 2u);

    const auto status = nlohmann::json::parse(status_of(session, Clock::now(), 3));
    EXPECT_EQ(status["rest"], true);
    EXPECT_EQ(status["viewers"], 3);
    EXPECT_EQ(status["width"], 160);
    EXPECT_EQ(status["values"].size(), told["switches"].size());
    EXPECT_EQ(status["values"]["look"], "color");
    EXPECT_EQ(status["corner"].get<std::string>().substr(0, 5), "exact");

    session.shown(*session.latest(), Clock::now());
    const auto bars = nlohmann::json::parse(bars_of(session, Clock::now(), 0));
    ASSERT_EQ(bars["frames"].size(), 1u);
    EXPECT_EQ(bars["frames"][0]["stages"].size(), told["stages"].size());
    EXPECT_GT(bars["frames"][0]["ms"], 0.0);
    EXPECT_TRUE(nlohmann::json::parse(bars_of(session, Clock::now(), 1))["frames"].empty());
}

TEST(SessionMessages, ReplaceWhatIsNoUtf8)
{
    const std::string text = text_message("refused", "a\xff z");
    EXPECT_NE(text.find("\xef\xbf\xbd"), std::string::npos) << text;
    EXPECT_TRUE(nlohmann::json::accept(text));
}

} // namespace
} // namespace firsthit::cli::view
