// file_identity_test.cpp - a file is known by any of its names.
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <gtest/gtest.h>

namespace firsthit {
namespace {

namespace fs = std::filesystem;

/// A folder with a file `real` and other names that lead to it.
struct Names {
    TemporaryFolder folder;
    std::vector<std::string> all;

    Names()
    {
        folder.write("real", "bytes");
        fs::create_symlink("real", folder / "symbolic");
        fs::create_symlink("symbolic", folder / "symbolic_twice");
        fs::create_hard_link(folder / "real", folder / "hard");
        fs::create_directory_symlink(".", folder / "sub");
        const fs::path here = fs::relative(folder / "real");
        all = {folder / "real", folder / "./real", folder / "sub/real", folder / "symbolic",
            folder / "symbolic_twice", folder / "hard", here.string()};
    }
};

TEST(SameFile, KnowsAFileByAllItsNames)
{
    const Names names;
    for (const std::string& a : names.all)
        for (const std::string& b : names.all) EXPECT_TRUE(same_file(a, b)) << a << " and " << b;
}

TEST(SameFile, TellsEqualBytesApart)
{
    const Names names;
    const std::string copy = names.folder.write("copy", "bytes").string();
    for (const std::string& name : names.all) EXPECT_FALSE(same_file(name, copy)) << name;
}

TEST(SameFile, OfFilesToComeIsWhereWritesEnd)
{
    const TemporaryFolder folder;
    fs::create_symlink("later", folder / "link");
    fs::create_directory_symlink(".", folder / "sub");
    EXPECT_TRUE(same_file(folder / "later", folder / "link"));
    EXPECT_TRUE(same_file(folder / "later", folder / "sub/link"));
    EXPECT_TRUE(same_file(folder / "none/../later", folder / "later"));
    EXPECT_FALSE(same_file(folder / "later", folder / "never"));
    folder.write("now", "bytes");
    EXPECT_FALSE(same_file(folder / "later", folder / "now"));
}

TEST(OutputTarget, IsWhatAWriteMakes)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "there");
    fs::create_symlink("there/later", folder / "link");
    const std::string target = output_target(folder / "link");
    EXPECT_EQ(target, fs::canonical(folder.path()) / "there/later");
    write_file(folder / "link", "bytes");
    EXPECT_EQ(bytes_of(target), "bytes");
    EXPECT_EQ(output_target(folder / "link"), target);
}

TEST(CheckInputsStay, RefusesEveryNameOfAnInputAndNamesBoth)
{
    const Names names;
    for (const std::string& input : names.all)
        for (const std::string& output : names.all) {
            const std::vector<std::string> inputs = {names.folder / "other", input};
            const std::vector<std::string> outputs = {names.folder / "fresh", output};
            EXPECT_EQ(message_of<FileError>([&] { check_inputs_stay(outputs, inputs); }),
                output + ": cannot write: it would replace the input '" + input + "'");
        }
}

TEST(CheckInputsStay, RefusesToMakeAnInputThatIsNotThere)
{
    const TemporaryFolder folder;
    fs::create_symlink("gone", folder / "link");
    const std::vector<std::string> inputs = {folder / "gone"};
    const std::vector<std::string> outputs = {folder / "link"};
    EXPECT_THROW(check_inputs_stay(outputs, inputs), FileError);
}

TEST(CheckInputsStay, LetsOtherFilesBeWritten)
{
    const Names names;
    const std::vector<std::string> outputs = {names.folder / "fresh",
        names.folder.write("copy", "bytes").string(), "/dev/null", "/dev/stdout"};
    check_inputs_stay(outputs, names.all);
    check_inputs_stay(outputs, {});
    check_inputs_stay({}, names.all);
    EXPECT_FALSE(fs::exists(names.folder / "fresh"));
}

} // namespace
} // namespace firsthit
