// environment_file_test.cpp - pictures of what is all around: right ones, and what is wrong with others.
#include "message_of.h"
#include "temporary_folder.h"

#include "readers/image/environment_file.h"

#include <firsthit/environment.h>
#include <firsthit/error.h>
#include <firsthit/film.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace firsthit {
namespace {

/// Values that both formats hold exactly: no more than 8 bits of the brightest.
std::vector<glm::vec3> values(int width, int height)
{
    std::vector<glm::vec3> all;
    for (int k = 0; k < width * height; ++k)
        all.emplace_back(float(128 + k % 100) / 64, float(k % 7) / 64, float(k % 128) / 64);
    return all;
}

/// A Radiance picture without runs.
std::string radiance_bytes(int width, int height, const std::vector<glm::vec3>& light)
{
    std::string bytes =
        fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", height, width);
    for (const glm::vec3& v : light) {
        // 2 <= red < 4: the exponent is 2, and a step is 2^(2 - 8).
        for (int c = 0; c < 3; ++c) bytes += char(std::lround(v[c] * 64));
        bytes += char(128 + 2);
    }
    return bytes;
}

void expect_same(const EnvironmentMap& a, const EnvironmentMap& b)
{
    ASSERT_EQ(a.texels().size(), b.texels().size());
    for (std::size_t k = 0; k < a.texels().size(); ++k) ASSERT_EQ(a.texels()[k], b.texels()[k]);
    EXPECT_EQ(a.diffuse(), b.diffuse());
}

TEST(EnvironmentFile, RadianceAndOpenExrGiveWhatTheyHold)
{
    const TemporaryFolder folder;
    constexpr int kWidth = 6, kHeight = 4; // below 8 wide, Radiance has no runs
    const std::vector<glm::vec3> light = values(kWidth, kHeight);
    const EnvironmentMap expected("sky", kWidth, kHeight, light);

    const std::string hdr =
        folder.write("sky.HDR", radiance_bytes(kWidth, kHeight, light)).string();
    expect_same(*load_environment(hdr), expected);
    EXPECT_EQ(load_environment(hdr)->name(), hdr);

    Film film;
    film.width = kWidth;
    film.height = kHeight;
    film.color.channels = 3;
    for (const glm::vec3& v : light)
        film.color.value.insert(film.color.value.end(), {v.x, v.y, v.z});
    const std::string exr = folder.write("sky.exr", "").string();
    write_color(film, exr);
    expect_same(*load_environment(exr), expected);
}

TEST(EnvironmentFile, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    const auto message = [&](const std::string& name, const std::string& bytes) {
        const std::string path = folder.write(name, bytes).string();
        const std::string said = message_of<FileError>([&] { load_environment(path); });
        EXPECT_NE(said.find(path), std::string::npos) << said;
        return said;
    };
    const auto expect = [](const std::string& said, const char* what) {
        EXPECT_NE(said.find(what), std::string::npos) << said;
    };
    expect(message("a.hdr", "P6 1 1 255 abc"), "not a Radiance picture");
    expect(message("b.hdr", ""), "not a Radiance picture");
    expect(message("c.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n\x01"),
        "accepted are sides of 1 to 16384");
    expect(
        message("d.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4096 +X 8192\n\x01"), "cut off");
    // A run of length 0, and one that is longer than its line.
    for (const char run : {char(0), char(128), char(9), char(128 + 9)}) {
        std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";
        bytes += {2, 2, 0, 8, run};
        bytes.append(64, char(1));
        expect(message("i.hdr", bytes), "a run does not fit into its line");
    }
    expect(message("e.hdr", "#?RADIANCE\n\n-Y 2 +X 2\n"), "Radiance");
    expect(message("f.exr", "no picture"), "not an OpenEXR picture");
    expect(message("g.exr", ""), "not an OpenEXR picture");

    Film film;
    film.width = 64;
    film.height = 32;
    film[Aov::depth].channels = 1;
    film[Aov::depth].value.assign(64 * 32, 1.0f);
    const std::string depth = folder.write("depth.exr", "").string();
    write_aov(film, Aov::depth, depth);
    expect(message("h.exr", bytes_of(depth)), "no channel R");
    const std::string whole = bytes_of(depth);
    expect(message("i.exr", whole.substr(0, whole.size() / 2)), "damaged");

    EXPECT_NE(message_of<ArgumentError>([&] {
        load_environment("sky.jpg");
    }).find("unknown ending '.jpg'"),
        std::string::npos);
    EXPECT_THROW(load_environment((folder.path() / "missing.hdr").string()), FileError);
}

TEST(EnvironmentFile, AnAttributeThatPromisesMoreThanTheFileHasTakesNoMemory)
{
    using namespace std::string_literals;
    const std::string begin = "\x76\x2f\x31\x01\x02\0\0\0"s;
    for (const std::string& attribute :
        {"a\0opaque\0\xff\xff\xff\x7f"s, "a\0float\0\x08\0\0\0\0\0\0\0\0\0\0\0"s,
            "channels\0chlist\0\x02\0\0\0RR"s, "p\0preview\0\x08\0\0\0\xff\x7f\0\0\xff\x7f\0\0"s,
            "s\0stringvector\0\x04\0\0\0\xff\xff\xff\x7f"s, "m\0idmanifest\0\x01\0\0\0x"s}) {
        try {
            decode_exr("sky.exr", begin + attribute + "\0"s);
            ADD_FAILURE() << "read";
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find("an attribute is damaged"), std::string::npos)
                << error.what();
        }
    }
}

} // namespace
} // namespace firsthit
