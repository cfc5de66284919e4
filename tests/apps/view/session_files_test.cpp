// session_files_test.cpp - files that a session reads again, that fail, and that it writes.
#include "apps/view/sessions.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace firsthit::cli::view {
namespace {

TEST(SessionFiles, AFileThatFailsLeavesTheOldScene)
{
    const TemporaryFolder folder;
    const std::string bad = folder / "bad.off";
    std::ofstream(bad) << "OFF\n3 1 0\nnonsense\n";
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(160, 120);
    ASSERT_TRUE(comes_to_rest(session));
    const std::vector<std::uint8_t> before = session.latest()->rgba;
    session.open(bad);
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_NE(session.message().find("bad.off"), std::string::npos) << session.message();
    EXPECT_EQ(session.latest()->rgba, before);
    EXPECT_EQ(session.scene().options().scene.name, "builtin:torus");
}

TEST(SessionFiles, AFileThatChangesIsReadAgain)
{
    const TemporaryFolder folder;
    const std::string file = folder / "one.off";
    std::ofstream(file) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    ViewSession session(options_of(file), [] {});
    session.resize(160, 120);
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_EQ(session.scene().first().triangle_count(), 1u);
    std::ofstream(file) << "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n";
    std::filesystem::last_write_time(
        file, std::filesystem::last_write_time(file) + std::chrono::seconds(2));
    for (int k = 0; k < 5000 && session.scene().first().triangle_count() != 2; ++k) {
        session.update();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(session.scene().first().triangle_count(), 2u);
}

/// The working folder of a test, and the one of before at its end.
class InFolder {
  public:
    explicit InFolder(const std::string& folder) { std::filesystem::current_path(folder); }
    ~InFolder() { std::filesystem::current_path(before_); }
    InFolder(const InFolder&) = delete;
    InFolder& operator=(const InFolder&) = delete;

  private:
    std::filesystem::path before_ = std::filesystem::current_path();
};

TEST(SessionFiles, OfManyThatAreOpenedTheLastIsShown)
{
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(80, 60);
    for (const char* name : {"builtin:robots", "none.off", "builtin:torus", "builtin:wave"})
        session.open(name);
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_EQ(session.scene().options().scene.name, "builtin:wave");
    EXPECT_EQ(session.message(), "");
}

TEST(SessionFiles, F12NeverReplacesAFile)
{
    const TemporaryFolder folder;
    const InFolder in(folder / ".");
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(80, 60);
    ASSERT_TRUE(comes_to_rest(session));
    session.key("f12", true);
    session.choose_switch("look", "depth");
    ASSERT_TRUE(comes_to_rest(session));
    session.key("f12", true);
    EXPECT_TRUE(std::filesystem::exists("firsthit-001.png"));
    EXPECT_TRUE(std::filesystem::exists("firsthit-002.png"));
    EXPECT_EQ(session.message(), "wrote firsthit-002.png: what is shown");
}

TEST(SessionFiles, AnErrorStaysUntilEscape)
{
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(80, 60);
    session.open("none.off");
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_NE(session.message().find("none.off"), std::string::npos);
    session.key("escape", true);
    EXPECT_EQ(session.message(), "");
    EXPECT_FALSE(session.wants_end());
}

TEST(SessionFiles, TheEnvironmentIsChosenWhileTheSceneIsShown)
{
    ViewSession session(options_of("builtin:torus"), [] {});
    session.resize(80, 60);
    ASSERT_TRUE(comes_to_rest(session));
    const auto has_map = [&] { return session.scene().first().environment.map != nullptr; };
    session.choose_switch("environment", "studio");
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_TRUE(has_map());
    session.choose_switch("environment", "none");
    ASSERT_TRUE(comes_to_rest(session));
    EXPECT_FALSE(has_map());
}

} // namespace
} // namespace firsthit::cli::view
