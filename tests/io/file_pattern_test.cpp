// file_pattern_test.cpp - names of numbered files, and which of them exist.
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/file_pattern.h>

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace firsthit {
namespace {

using Numbers = std::vector<int>;

TEST(FilePattern, PutsTheNumberInItsPlace)
{
    EXPECT_EQ(FilePattern("out/a_%04d.png").name(7), "out/a_0007.png");
    EXPECT_EQ(FilePattern("a%d.png").name(123), "a123.png");
    EXPECT_EQ(FilePattern("a%3d.png").name(5), "a  5.png");
    EXPECT_EQ(FilePattern("100%%_%0d%%").name(5), "100%_5%");
    EXPECT_EQ(FilePattern("%02d").name(12345), "12345");
}

TEST(FilePattern, RefusesAllOtherConversions)
{
    for (const char* text : {"", "a.obj", "%%", "%", "a%", "%s", "%n", "%x", "%u", "%4", "%04",
             "%-4d", "%+d", "% d", "%ld", "%10d", "%99999d", "%0999999d", "%.3d", "%*d", "%1$d",
             "%d%d", "%d_%04d", "%d%n", "%d%s", "%hhn", "%%%", "%d%"})
        EXPECT_THROW(FilePattern{text}, ArgumentError) << text;
    EXPECT_EQ(message_of<ArgumentError>([] { FilePattern("a/%s.obj"); }),
        "'a/%s.obj' has a % that is not %d, %4d or %04d: the names of numbered files need exactly "
        "one place for their number, as in frames_%04d");
    EXPECT_EQ(message_of<ArgumentError>([] { FilePattern("%d/%d.obj"); }),
        "'%d/%d.obj' has more than one %: the names of numbered files need exactly one place for "
        "their number, as in frames_%04d");
}

TEST(FilePattern, RandomTextIsAPatternOrRefused)
{
    std::mt19937 random(7);
    const std::string letters = "%%%%dd0149sn*.-+ $l/a";
    int accepted = 0;
    for (int round = 0; round < 50'000; ++round) {
        std::string text;
        for (std::size_t k = random() % 8; k > 0; --k) text += letters[random() % letters.size()];
        try {
            const FilePattern pattern(text);
            ++accepted;
            // One number makes the difference between two names, and it is there.
            const std::string name = pattern.name(987654321);
            EXPECT_NE(name.find("987654321"), std::string::npos) << text;
            EXPECT_NE(name, pattern.name(987654322)) << text;
            EXPECT_LE(pattern.name(1).size(), text.size() + 9) << text;
        } catch (const ArgumentError&) {
        }
    }
    EXPECT_GT(accepted, 300);
}

TEST(FilePattern, FindsTheFilesThatHaveItsNames)
{
    const TemporaryFolder folder;
    for (const char* name : {"a_0002.obj", "a_0010.obj", "a_0001.obj", "a_12345.obj", "a_3.obj",
             "a_00004.obj", "a_000x.obj", "b_0005.obj", "a_0006.obj.mtl", "a_.obj", "a_-001.obj",
             "a_99999999999.obj", "a_+007.obj"})
        folder.write(name, "x");
    std::filesystem::create_directory(folder / "a_0008.obj");
    EXPECT_EQ(FilePattern(folder / "a_%04d.obj").existing(), (Numbers{1, 2, 10, 12345}));
    EXPECT_EQ(FilePattern(folder / "a_%d.obj").existing(), (Numbers{3, 12345}));
    EXPECT_EQ(FilePattern(folder / "c_%d.obj").existing(), Numbers{});
}

TEST(FilePattern, TheNumberMayFillUpWithSpacesOrBeInAFolder)
{
    const TemporaryFolder folder;
    for (const char* name : {"a  7.obj", "a 12.obj", "a8.obj", "take1/m.obj", "take2/m.obj",
             "take3/n.obj", "100%4.obj"})
        folder.write(name, "x");
    EXPECT_EQ(FilePattern(folder / "a%3d.obj").existing(), (Numbers{7, 12}));
    EXPECT_EQ(FilePattern(folder / "take%d/m.obj").existing(), (Numbers{1, 2}));
    EXPECT_EQ(FilePattern(folder / "100%%%d.obj").existing(), (Numbers{4}));
}

TEST(FilePattern, NamesTheFolderThatIsMissing)
{
    EXPECT_EQ(message_of<FileError>([] { (void)FilePattern("no/such/%d.obj").existing(); }),
        "no/such/%d.obj: the folder 'no/such/' cannot be listed: No such file or directory");
}

} // namespace
} // namespace firsthit
