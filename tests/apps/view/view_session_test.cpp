// view_session_test.cpp - a session without a window: its picture at rest is that of `render`.
#include "view/session/view_session.h"

#include "common/usage.h"
#include "apps/view/sessions.h"
#include "message_of.h"

#include <firsthit/error.h>
#include <firsthit/film_data.h>
#include <firsthit/render.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <thread>

namespace firsthit::cli::view {
namespace {

/// The picture of the library alone, with the state of a session.
Film rendered(const ViewSession& session)
{
    const std::shared_ptr<const ShownFrame> frame = session.latest();
    // Lit as the session lights it; tests/apps/view_cli_test.sh holds it against the program's own.
    const auto scene = const_cast<ViewScene&>(session.scene()).scene_at(session.state().time_s);
    Renderer renderer(2);
    World world;
    renderer.pose(scene, {.time_s = session.state().time_s, .clip = session.state().clip}, world);
    View view;
    view.camera = frame->camera;
    hang_lights(view.camera, world);
    view.width = session.width();
    view.height = session.height();
    Film film;
    renderer.render(world, view, session.state().settings, film);
    return film;
}

void expect_picture_of_render(ViewSession& session, const std::string& what)
{
    ASSERT_TRUE(comes_to_rest(session)) << what;
    ASSERT_EQ(session.message(), "") << what;
    const std::shared_ptr<const ShownFrame> frame = session.latest();
    EXPECT_EQ(frame->missing, "") << what;
    const Film film = rendered(session);
    EXPECT_EQ(frame->film.color.value, film.color.value) << what;
    const std::vector<std::uint8_t> rgb = srgb_pixels(film, session.state().tone);
    std::vector<std::uint8_t> shown;
    for (std::size_t k = 0; k < frame->rgba.size(); ++k)
        if (k % 4 != 3) shown.push_back(frame->rgba[k]);
    EXPECT_EQ(shown, rgb) << what;
}

TEST(ViewSession, AtRestShowsThePictureOfRender)
{
    ViewSession session(options_of("builtin:robots"), [] {});
    session.resize(160, 120);
    int tried = 0;
    session.choose_switch("time", "1.5");
    for (const char* shadows : {"none", "map", "exact"})
        for (const char* sampling : {"aa 1", "aa 3", "samples 2", "interleave 4"})
            for (const char* sky : {"0", "5"})
                for (const char* tile : {"64", "16"}) {
                    const std::string text = sampling;
                    const std::size_t space = text.find(' ');
                    session.choose_switch("shadows", shadows);
                    session.choose_switch("aa", "1");
                    session.choose_switch("samples", "1");
                    session.choose_switch("interleave", "1");
                    session.choose_switch(text.substr(0, space), text.substr(space + 1));
                    session.choose_switch("sky", sky);
                    session.choose_switch("tile-size", tile);
                    expect_picture_of_render(session,
                        fmt::format("shadows {}, {}, sky {}, tiles {}", shadows, text, sky, tile));
                    ++tried;
                }
    EXPECT_GE(tried, 40);
}

TEST(ViewSession, AfterMovingItRestsAtTheExactPicture)
{
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(160, 120);
    ASSERT_TRUE(comes_to_rest(session));
    const Film before = session.latest()->film;
    session.pointer_moves(80, 60);
    session.button(Button::left, true);
    for (int k = 1; k <= 20; ++k) {
        session.pointer_moves(80 + k, 60 + k / 2);
        session.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    session.button(Button::left, false);
    EXPECT_FALSE(session.is_at_rest(Clock::now()));
    expect_picture_of_render(session, "orbit");
    EXPECT_NE(session.latest()->film.color.value, before.color.value);
}

TEST(ViewSession, KeysDoWhatTheirPageSays)
{
    ViewSession session(options_of("builtin:robots"), [] {});
    session.resize(160, 120);
    ASSERT_TRUE(comes_to_rest(session));
    std::string camera = session.camera_options();
    for (const char* key : {"1", "3", "7", "0", "shift+1", "shift+3", "shift+7", "left", "up",
             "right", "down", "+", "-"}) {
        EXPECT_TRUE(session.key(key, true)) << key;
        session.key(key, false);
        EXPECT_NE(session.camera_options(), camera) << key;
        camera = session.camera_options();
    }
    const auto changes = [&](const char* key, const char* name) {
        const std::string before = switch_named(name).get(session.state());
        EXPECT_TRUE(session.key(key, true)) << key;
        EXPECT_NE(switch_named(name).get(session.state()), before) << key;
    };
    changes("space", "play");
    changes(".", "time");
    changes(",", "time");
    changes("[", "speed");
    changes("]", "speed");
    changes("l", "loop");
    changes("t", "turntable");
    changes("t", "turntable");
    changes("v", "look");
    changes("shift+v", "look");
    changes("g", "engine");
    changes("h", "shadows");
    changes("tab", "panel");
    changes("b", "bars");
    changes("i", "hover");
    changes("?", "help");
    EXPECT_FALSE(session.key("f7", true));
    EXPECT_TRUE(session.key("c", true));
    EXPECT_EQ(session.take_copied().value_or("").substr(0, 6), "--eye ");
    EXPECT_TRUE(session.key("escape", true)); // closes the page
    EXPECT_FALSE(session.wants_end());
    EXPECT_TRUE(session.key("escape", true));
    EXPECT_TRUE(session.wants_end());
}

TEST(ViewSession, EveryLookIsAnotherPicture)
{
    ViewSession session(options_of("builtin:robots"), [] {});
    session.resize(160, 120);
    std::set<std::vector<std::uint8_t>> pictures;
    session.choose_switch("shadows", "map"); // so that there is a difference from exact
    const std::vector<std::string> looks = switch_named("look").words;
    for (const std::string& look : looks) {
        session.choose_switch("look", look);
        ASSERT_TRUE(comes_to_rest(session)) << look;
        EXPECT_EQ(session.message(), "") << look;
        EXPECT_TRUE(pictures.insert(session.latest()->rgba).second) << look;
    }
    session.choose_switch("look", "difference");
    session.choose_switch("shadows", "exact");
    ASSERT_TRUE(comes_to_rest(session));
    const std::vector<std::uint8_t>& rgba = session.latest()->rgba;
    for (std::size_t k = 0; k < rgba.size(); ++k) ASSERT_EQ(rgba[k], k % 4 == 3 ? 255 : 0);
}

TEST(ViewSession, TellsWhatIsUnderThePointerAndSelectsIt)
{
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(160, 120);
    session.key("1", true);
    ASSERT_TRUE(comes_to_rest(session));
    const auto pick_at = [&](double x, double y) {
        session.pointer_moves(x, y);
        for (int k = 0; k < 2000 && !session.latest_pick(); ++k) {
            session.update();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return session.latest_pick();
    };
    const std::optional<Pick> nothing = pick_at(1, 1);
    ASSERT_TRUE(nothing);
    EXPECT_FALSE(nothing->hit);
    EXPECT_EQ(told(*nothing).back(), "background");
    std::optional<Pick> found;
    for (int y = 20; y < 110 && !(found && found->hit); y += 7) found = pick_at(80, y);
    ASSERT_TRUE(found && found->hit);
    // The same as the planes of a whole frame.
    Film film;
    Renderer renderer(1);
    World world;
    pose(std::make_shared<const Scene>(load_scene("builtin:torus")), 0, world);
    Settings settings;
    settings.aovs = {Aov::item, Aov::depth};
    renderer.render(world,
        {.camera = session.latest()->camera, .width = 160, .height = 120, .region = {}}, settings,
        film);
    const std::size_t pixel = std::size_t(found->y) * 160 + std::size_t(found->x);
    EXPECT_EQ(found->triangle, film.item[pixel]);
    EXPECT_EQ(found->t, film[Aov::depth].value[pixel]);

    const std::vector<std::uint8_t> before = session.latest()->rgba;
    session.button(Button::left, true);
    session.button(Button::left, false);
    EXPECT_EQ(session.state().selected, std::int32_t(found->instance));
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_NE(session.latest()->rgba, before) << "the outline";
}

TEST(ViewSession, WrongChoicesChangeNothing)
{
    ViewSession session(options_of("builtin:torus"), [] {});
    EXPECT_NE(message_of<UsageError>([&] { session.choose_switch("clip", "3"); }), "no error");
    EXPECT_NE(message_of<UsageError>([&] { session.choose_switch("camera", "9"); }), "no error");
    EXPECT_NE(
        message_of<UsageError>([&] { session.choose_switch("look", "sideways"); }), "no error");
    EXPECT_EQ(session.state().look, Look::color);
}

TEST(ViewSession, AFrameThatIsNotWantedAnyMoreIsGivenUp)
{
    RenderOptions options = options_of("builtin:robots");
    ViewSession session(options, [] {});
    session.resize(1200, 900);
    session.choose_switch("samples", "8"); // takes seconds
    session.update();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    session.choose_switch("samples", "1");
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_GE(session.cancelled(), 1u);
    EXPECT_EQ(session.latest()->request.state.settings.samples, 1);
}

} // namespace
} // namespace firsthit::cli::view
