// served_session_test.cpp - a session that several pages look at: who gets which picture, and whose hand counts.
#include "view/serve/served_session.h"

#include "common/usage.h"
#include "message_of.h"
#include "apps/view/sessions.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace firsthit::cli::view {
namespace {

ViewOptions served_options(const std::string& scene)
{
    ViewOptions options;
    options.picture = options_of(scene);
    options.size_given = true;
    options.serve = ListenAddress{};
    return options;
}

/// A page that remembers what it was sent.
struct TestPage {
    ServedSession& session;
    Viewer& viewer;
    std::uint32_t number = 0, pictures = 0;
    bool lossless = false, reads = true;
    std::string bytes{}, last_text{};
    nlohmann::json status{};

    explicit TestPage(ServedSession& given) : session(given), viewer(given.join()) {}

    void say(const std::string& text) { session.take(viewer, parse_client_message(text)); }

    void hear()
    {
        while (const auto out = session.next(viewer, Clock::now())) {
            if (!out->is_picture) {
                const auto told = nlohmann::json::parse(*out->bytes);
                if (told["kind"] == "status") status = told;
                if (told["kind"] == "refused") last_text = told["text"];
                continue;
            }
            ++pictures;
            const auto byte = [&](std::size_t k) {
                return static_cast<std::uint32_t>(static_cast<unsigned char>((*out->bytes)[k]));
            };
            number = byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
            lossless = byte(4) == 1;
            bytes = out->bytes->substr(12);
            if (reads) see();
        }
    }
    void see() { say(R"({"do":"seen","number":)" + std::to_string(number) + "}"); }
};

template <class Holds>
bool comes_true(ServedSession& session, std::initializer_list<TestPage*> pages, const Holds& holds)
{
    const auto begin = Clock::now();
    while (Clock::now() - begin < std::chrono::minutes(1)) {
        session.update(Clock::now());
        for (TestPage* page : pages) page->hear();
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

TEST(ServedSession, SendsThePictureAtRestWithoutLoss)
{
    ServedSession session(served_options("builtin:torus"), [] {});
    session.update(Clock::now()); // nobody looks: nothing is made
    TestPage page(session);
    ASSERT_TRUE(comes_true(session, {&page}, [&] { return page.lossless; }));
    EXPECT_EQ(page.bytes.substr(1, 3), "PNG");
    EXPECT_EQ(page.status["viewers"], 1);
    TestPage other(session); // one who comes later gets it too
    ASSERT_TRUE(comes_true(session, {&page, &other}, [&] { return other.lossless; }));
    EXPECT_EQ(other.bytes, page.bytes);
}

TEST(ServedSession, SendsOnePictureAtATime)
{
    ServedSession session(served_options("builtin:robots"), [] {});
    TestPage quick(session), slow(session);
    slow.reads = false;
    quick.say(R"({"do":"choose","switch":"play","value":"on"})");
    ASSERT_TRUE(comes_true(session, {&quick, &slow}, [&] { return quick.pictures >= 20; }));
    EXPECT_EQ(slow.pictures, 1u);
    EXPECT_FALSE(quick.lossless);
    slow.see(); // now it gets the newest one
    ASSERT_TRUE(comes_true(session, {&slow}, [&] { return slow.pictures == 2; }));
    EXPECT_GE(slow.number, 20u);
    EXPECT_NE(message_of<UsageError>([&] { slow.say(R"({"do":"seen","number":1})"); }), "");
}

TEST(ServedSession, OneHandHoldsTheCamera)
{
    ServedSession session(served_options("builtin:torus"), [] {});
    TestPage one(session);
    const auto rests = [&] { return one.lossless && one.status.value("rest", false); };
    ASSERT_TRUE(comes_true(session, {&one}, rests));
    const std::string first = session.session().camera_options();
    Viewer& other = session.join();
    const auto other_says = [&](const char* text) {
        session.take(other, parse_client_message(text));
    };
    one.say(R"({"do":"move","x":50,"y":50})");
    one.say(R"({"do":"button","button":"left","down":true,"shift":false})");
    other_says(R"({"do":"move","x":90,"y":50})"); // does not drag
    other_says(R"({"do":"button","button":"left","down":false,"shift":false})");
    EXPECT_TRUE(session.session().holds_button());
    EXPECT_EQ(session.session().camera_options(), first);
    one.say(R"({"do":"move","x":70,"y":50})");
    EXPECT_NE(session.session().camera_options(), first);
    const std::string turned = session.session().camera_options();
    session.leave(one.viewer); // with the button held
    EXPECT_FALSE(session.session().holds_button());
    other_says(R"({"do":"move","x":90,"y":50})");
    EXPECT_EQ(session.session().camera_options(), turned);
    EXPECT_EQ(session.viewers(), 1u);
}

TEST(ServedSession, TellsWhatItDoesNotAccept)
{
    ServedSession session(served_options("builtin:torus"), [] {});
    TestPage page(session);
    page.say(R"({"do":"choose","switch":"samples","value":"99"})");
    ASSERT_TRUE(comes_true(session, {&page}, [&] { return !page.last_text.empty(); }));
    EXPECT_NE(page.last_text.find("1 to 16"), std::string::npos) << page.last_text;
    for (int k = 0; k < 100; ++k) page.say(R"({"do":"choose","switch":"x","value":"1"})");
    for (const char* key : {"f12", "shift+f12", "tab", "?"})
        EXPECT_NE(message_of<UsageError>([&] {
            page.say(std::string(R"({"do":"key","down":true,"name":")") + key + "\"}");
        }),
            "")
            << key;
}

TEST(ServedSession, TheFirstPageSaysHowLargeThePictureIs)
{
    ViewOptions options = served_options("builtin:torus");
    ServedSession fixed(options, [] {});
    TestPage page(fixed);
    page.say(R"({"do":"resize","width":64,"height":48})");
    EXPECT_EQ(fixed.session().width(), 160); // --size
    options.size_given = false;
    ServedSession free(options, [] {});
    TestPage first(free), second(free);
    first.say(R"({"do":"resize","width":64,"height":48})");
    second.say(R"({"do":"resize","width":32,"height":32})");
    EXPECT_EQ(free.session().width(), 64);
    EXPECT_EQ(free.session().height(), 48);
}

} // namespace
} // namespace firsthit::cli::view
