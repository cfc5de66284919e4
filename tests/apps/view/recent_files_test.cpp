// recent_files_test.cpp - which files were looked at last.
#include "view/session/recent_files.h"

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace firsthit::cli::view {
namespace {

TEST(RecentFiles, TheLatestIsFirstAndOnce)
{
    RecentFiles files;
    for (const char* name : {"/a", "/b", "/a"}) files.add(name);
    EXPECT_EQ(files.names(), (std::vector<std::string>{"/a", "/b"}));
}

TEST(RecentFiles, AreKeptFromRunToRun)
{
    const TemporaryFolder folder;
    const std::string list = folder / "new/recent";
    {
        RecentFiles files(list);
        for (int k = 0; k < 15; ++k) files.add("/scene" + std::to_string(k));
    }
    const RecentFiles files(list);
    ASSERT_EQ(files.names().size(), RecentFiles::kMost);
    EXPECT_EQ(files.names().front(), "/scene14");
    EXPECT_EQ(files.names().back(), "/scene5");
}

TEST(RecentFiles, BuiltInScenesAreNoFiles)
{
    RecentFiles files;
    for (const char* name : {"builtin:torus", "-", "two\nlines"}) files.add(name);
    EXPECT_TRUE(files.names().empty());
}

TEST(RecentFiles, AListThatCannotBeWrittenIsNoError)
{
    const TemporaryFolder folder;
    const std::string file = folder / "file";
    std::ofstream(file) << "/old\n";
    RecentFiles files(file + "/below/recent");
    files.add("/new");
    EXPECT_EQ(files.names(), std::vector<std::string>{"/new"});
}

} // namespace
} // namespace firsthit::cli::view
