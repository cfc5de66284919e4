// output_file_test.cpp - a file appears whole or not at all.
#include "io/output_file.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

namespace firsthit {
namespace {

TEST(OutputFile, IsNotThereUntilItIsCommitted)
{
    const TemporaryFolder folder;
    OutputFile file(folder / "a.bin");
    file.write("abc", 3);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.bin"));
    file.commit();
    EXPECT_EQ(bytes_of(folder / "a.bin"), "abc");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.bin"});
}

TEST(OutputFile, LeavesNothingWithoutACommit)
{
    const TemporaryFolder folder;
    {
        OutputFile file(folder / "a.bin");
        file.write("abc", 3);
    }
    EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFile, LeavesTheOldFileWithoutACommit)
{
    const TemporaryFolder folder;
    write_file(folder / "a.bin", "old");
    {
        OutputFile file(folder / "a.bin");
        file.write("new", 3);
    }
    EXPECT_EQ(bytes_of(folder / "a.bin"), "old");
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, ReplacesTheOldFile)
{
    const TemporaryFolder folder;
    write_file(folder / "a.bin", "a longer old text");
    write_file(folder / "a.bin", "new");
    EXPECT_EQ(bytes_of(folder / "a.bin"), "new");
}

TEST(OutputFile, GoesBackToAnOffset)
{
    const TemporaryFolder folder;
    OutputFile file(folder / "a.bin");
    file.write("abcdef", 6);
    file.seek(1);
    file.write("XY", 2);
    EXPECT_EQ(file.tell(), 3u);
    file.commit();
    EXPECT_EQ(bytes_of(folder / "a.bin"), "aXYdef");
}

TEST(OutputFile, FollowsALinkAndKeepsIt)
{
    const TemporaryFolder folder;
    write_file(folder / "real.bin", "old");
    std::filesystem::create_symlink("real.bin", folder / "link.bin");
    write_file(folder / "link.bin", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.bin"));
    EXPECT_EQ(bytes_of(folder / "real.bin"), "new");
}

TEST(OutputFile, FollowsLinksThatLeadToNothingYet)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "there");
    std::filesystem::create_symlink("there/second.bin", folder / "first.bin");
    std::filesystem::create_symlink("../real.bin", folder / "there/second.bin");
    {
        OutputFile file(folder / "first.bin");
        file.write("new", 3);
        EXPECT_FALSE(std::filesystem::exists(folder / "real.bin"));
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"first.bin", "there"}));
    write_file(folder / "first.bin", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "first.bin"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "there/second.bin"));
    EXPECT_EQ(bytes_of(folder / "real.bin"), "new");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"first.bin", "real.bin", "there"}));
}

TEST(OutputFile, ALinkIntoAMissingFolderIsAnError)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("none/real.bin", folder / "link.bin");
    const std::string path = folder / "link.bin";
    EXPECT_EQ(message_of<FileError>([&] { write_file(path, "new"); }),
        path + ": cannot write: the folder '" + (folder / "none") + "' does not exist");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"link.bin"});
}

TEST(OutputFile, LinksInACircleAreAnError)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("b.bin", folder / "a.bin");
    std::filesystem::create_symlink("a.bin", folder / "b.bin");
    const std::string path = folder / "a.bin";
    EXPECT_EQ(message_of<FileError>([&] { write_file(path, "new"); }),
        path + ": cannot write: Too many levels of symbolic links");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.bin", "b.bin"}));
}

TEST(OutputFile, KeepsThePermissionsOfTheOldFile)
{
    const TemporaryFolder folder;
    std::filesystem::create_symlink("a.bin", folder / "link.bin");
    const mode_t before = umask(022);
    for (const mode_t mode : {0600u, 0644u, 0666u, 0755u, 0200u}) {
        for (const char* const name : {"a.bin", "link.bin"}) {
            std::filesystem::remove(folder / "a.bin");
            write_file(folder / "a.bin", "old");
            chmod((folder / "a.bin").c_str(), mode);
            write_file(folder / name, "new");
            struct stat status {};
            stat((folder / "a.bin").c_str(), &status);
            EXPECT_EQ(status.st_mode & 07777, mode) << name;
        }
    }
    umask(before);
}

TEST(OutputFile, IsAtNoTimeOpenToOthersThanTheOldFileWas)
{
    const TemporaryFolder folder;
    write_file(folder / "a.bin", "old");
    chmod((folder / "a.bin").c_str(), 0600);
    OutputFile file(folder / "a.bin");
    for (const std::string& name : folder.names()) {
        struct stat status {};
        stat((folder / name).c_str(), &status);
        EXPECT_EQ(status.st_mode & 07777, 0600u) << name;
    }
    EXPECT_EQ(folder.names().size(), 2u);
}

TEST(OutputFile, AFreshFileObeysTheUmask)
{
    const TemporaryFolder folder;
    const mode_t before = umask(027);
    write_file(folder / "a.bin", "new");
    umask(before);
    struct stat status {};
    stat((folder / "a.bin").c_str(), &status);
    EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(OutputFile, AFileBeyondTheLimitOnSizesIsReportedAndLeavesNothing)
{
    const TemporaryFolder folder;
    const std::string path = folder / "a.bin";
    const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{.rlim_cur = 4096, .rlim_max = before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message =
        message_of<FileError>([&] { write_file(path, std::string(1 << 20, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, ignored);
    EXPECT_EQ(message, path + ": cannot write: File too large");
    EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFile, AMissingFolderIsNamed)
{
    const TemporaryFolder folder;
    const std::string path = folder / "none/a.bin";
    EXPECT_EQ(message_of<FileError>([&] { OutputFile file(path); }),
        path + ": cannot write: the folder '" + (folder / "none") + "' does not exist");
}

TEST(OutputFile, AFolderIsNoFile)
{
    const TemporaryFolder folder;
    const std::string path = folder / "";
    EXPECT_EQ(message_of<FileError>([&] { OutputFile file(path); }),
        path + ": cannot write: Is a directory");
}

TEST(OutputFile, AFileIsNoFolder)
{
    const TemporaryFolder folder;
    write_file(folder / "a", "text");
    EXPECT_EQ(message_of<FileError>([&] { OutputFile file(folder / "a/b.bin"); }),
        (folder / "a/b.bin") + ": cannot write: Not a directory");
}

TEST(OutputFile, AnEmptyNameIsAnError)
{
    EXPECT_EQ(message_of<FileError>([] { OutputFile file(""); }),
        "cannot write to a file without a name");
}

TEST(OutputFile, AFolderWithoutPermissionIsAnError)
{
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "closed");
    chmod((folder / "closed").c_str(), 0500);
    EXPECT_EQ(message_of<FileError>([&] { OutputFile file(folder / "closed/a"); }),
        (folder / "closed/a") + ": cannot write: Permission denied");
}

TEST(OutputFile, ANameThatIsTooLongLeavesNothing)
{
    const TemporaryFolder folder;
    const std::string path = folder / std::string(300, 'x');
    EXPECT_EQ(message_of<FileError>([&] { write_file(path, "text"); }),
        path + ": cannot write: File name too long");
    EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFile, AFullDiskIsReported)
{
    EXPECT_EQ(message_of<FileError>([] { write_file("/dev/full", "text"); }),
        "/dev/full: cannot write: No space left on device");
}

TEST(OutputFile, SaysItAgainAtTheCommitWhenAnErrorWasSwallowed)
{
    const std::string block(1 << 20, 'x');
    OutputFile file("/dev/full");
    EXPECT_EQ(message_of<FileError>([&] { file.write(block.data(), block.size()); }),
        "/dev/full: cannot write: No space left on device");
    EXPECT_TRUE(file.failed());
    EXPECT_EQ(message_of<FileError>([&] { file.commit(); }),
        "/dev/full: cannot write: No space left on device");
}

TEST(OutputFile, ADeviceIsWrittenDirectlyAndStaysADevice)
{
    write_file("/dev/null", "text");
    EXPECT_TRUE(is_device("/dev/null"));
}

TEST(OutputFile, AskingBeforehandCreatesNothing)
{
    const TemporaryFolder folder;
    check_output_path(folder / "a.bin");
    EXPECT_TRUE(folder.names().empty());
    EXPECT_THROW(check_output_path(folder / "none/a.bin"), FileError);
}

} // namespace
} // namespace firsthit
