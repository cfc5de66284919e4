// npz_file_test.cpp - a .npz file is a ZIP archive of arrays, byte by byte. That NumPy reads it is in the tests of the
// program (tests/apps/cast_cli_test.sh).
#include "io/npy_header.h"
#include "io/whole_file.h"
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/npz.h>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace firsthit::test {
namespace {

TEST(NpzFile, HoldsItsArrays)
{
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.npz").string();
    const std::array<float, 4> values{1, 2, 3, 4};
    const std::array<std::uint8_t, 1> byte{7};
    const NpzArray arrays[] = {{"uv", "<f4", {2, 2}, std::as_bytes(std::span(values))},
        {"any", "|u1", {1}, std::as_bytes(std::span(byte))}, {"none", "<u4", {0}, {}}};
    write_npz(path, arrays);
    const std::string bytes = read_whole_file(path, 1 << 20);
    const std::string uv = npy_header("<f4", "(2, 2)");
    EXPECT_EQ(bytes.substr(0, 4), "PK\3\4");
    EXPECT_EQ(bytes.substr(30, 6), "uv.npy");
    EXPECT_EQ(bytes.substr(36, uv.size()), uv);
    EXPECT_EQ(
        bytes.compare(36 + uv.size(), 16, reinterpret_cast<const char*>(values.data()), 16), 0);
    EXPECT_NE(bytes.find(npy_header("|u1", "(1,)") + "\7"), std::string::npos);
    EXPECT_NE(bytes.find(npy_header("<u4", "(0,)")), std::string::npos);
    EXPECT_EQ(bytes.substr(bytes.size() - 22, 12), std::string("PK\5\6\0\0\0\0\3\0\3\0", 12));
    write_npz(path, arrays);
    EXPECT_EQ(read_whole_file(path, 1 << 20), bytes);
}

TEST(NpzFile, RefusesWhatDoesNotFit)
{
    const TemporaryFolder folder;
    const std::array<float, 4> values{};
    const NpzArray wrong{"t", "<f4", {3}, std::as_bytes(std::span(values))};
    EXPECT_EQ(message_of<ArgumentError>([&] {
        write_npz((folder.path() / "a.npz").string(), {&wrong, 1});
    }),
        "array t: 16 bytes for the shape (3,) of <f4");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.npz"));
}

} // namespace
} // namespace firsthit::test
