// texture_test.cpp - pictures as textures and their smaller levels.
#include "base/srgb.h"
#include "scene/image_file.h"
#include "scene/mip_levels.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace firsthit {
namespace {

constexpr std::uint32_t kBlack = 0xFF000000u;
constexpr std::uint32_t kWhite = 0xFFFFFFFFu;

Texture texture_of(int width, int height, std::vector<std::uint32_t> texels)
{
    Texture texture;
    texture.levels.push_back({width, height, std::move(texels)});
    make_mip_levels(texture);
    return texture;
}

std::vector<std::uint32_t> texels_of(const std::string& bytes)
{
    return decode_texture("t", bytes).levels[0].texel;
}

using Texels = std::vector<std::uint32_t>;

// A 2 x 2 PNG, 8 bits, red, green, blue and half transparent white, made with zlib.
const std::string kPng(
    "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x02\x00\x00"
    "\x00\x02\x08\x06\x00\x00\x00\x72\xb6\x0d\x24\x00\x00\x00\x13\x49\x44\x41\x54\x78\x9c\x63"
    "\xf8\xcf\xc0\xf0\x1f\x0c\x81\x34\x08\x34\x00\x00\x49\x49\x09\x78\x28\xa0\xdb\x77\x00\x00"
    "\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82",
    76);

TEST(Texture, ReadsColourPicturesFromTheTop)
{
    EXPECT_EQ(texels_of(std::string("P6\n2 1\n255\n\x01\x02\x03\x04\x05\x06", 17)),
        (Texels{0xFF030201u, 0xFF060504u}));
}

TEST(Texture, ReadsGreyPictures)
{
    EXPECT_EQ(texels_of("P5 1 2 255 \x20\x40"), (Texels{0xFF202020u, 0xFF404040u}));
}

TEST(Texture, SkipsCommentsInHeaders)
{
    EXPECT_EQ(texels_of("P5 # a picture\n# of\n1 # x\n1\n255\n\x20"), Texels{0xFF202020u});
}

TEST(Texture, ScalesOtherMaxima)
{
    EXPECT_EQ(texels_of(std::string("P5 3 1 15 \x00\x05\x0f", 13)),
        (Texels{kBlack, 0xFF555555u, kWhite}));
    EXPECT_EQ(
        texels_of(std::string("P5 2 1 65535 \x80\x80\xff\xff", 17)), (Texels{0xFF808080u, kWhite}));
    EXPECT_EQ(texels_of(std::string("P5 1 1 15 \xff", 11)), Texels{kWhite}) << "clamped";
}

TEST(Texture, ReadsPngWithAlpha)
{
    EXPECT_EQ(texels_of(kPng), (Texels{0xFF0000FFu, 0xFF00FF00u, 0xFFFF0000u, 0x80FFFFFFu}));
}

/// An 8 x 8 grey JPEG whose only block has no coefficients: one grey of 128.
std::string grey_jpeg()
{
    using namespace std::string_literals;
    const std::string one_code = "\x01"s + std::string(15, '\0'); // one Huffman code of one bit
    return "\xff\xd8"                                             // start
           "\xff\xdb\x00\x43\x00"s +
           std::string(64, '\x01') +                                           // quantisation: 1
           "\xff\xc0\x00\x0b\x08\x00\x08\x00\x08\x01\x01\x11\x00"s +           // 8 x 8, one channel
           "\xff\xc4\x00\x14\x00"s + one_code + "\x00"s +                      // 0: no change
           "\xff\xc4\x00\x14\x10"s + one_code + "\x00"s +                      // 0: end of block
           "\xff\xda\x00\x08\x01\x01\x00\x00\x3f\x00"s + "\x3f"s + "\xff\xd9"; // 00, end
}

TEST(Texture, ReadsJpeg)
{
    EXPECT_EQ(texels_of(grey_jpeg()), Texels(64, 0xFF808080u));
    EXPECT_THROW(decode_texture("t", grey_jpeg().substr(0, 90)), FileError);
}

TEST(Texture, ReadsFromTheDiskUnderItsName)
{
    const TemporaryFolder folder;
    const auto path = folder.write("a.png", kPng);
    const Texture texture = read_texture(path);
    EXPECT_EQ(texture.name, path.string());
    EXPECT_EQ(texture.levels.size(), 2u);
}

void expect_refused(const std::string& bytes, const std::string& message)
{
    EXPECT_EQ(message_of<FileError>([&] { decode_texture("t", bytes); }).substr(0, message.size()),
        message);
}

TEST(Texture, RefusesWhatIsNoPicture)
{
    const std::string refused = "t: not a PNG, JPEG or binary PPM picture, or a damaged one (";
    expect_refused("", refused);
    expect_refused("hello", refused);
    expect_refused("P3 1 1 255 1 2 3", refused);
}

TEST(Texture, RefusesPngThatIsCutOffAnywhere)
{
    for (std::size_t size = 0; size < kPng.size(); ++size)
        EXPECT_THROW(decode_texture("t", kPng.substr(0, size)), FileError);
}

TEST(Texture, RefusesPngWhoseChunksPromiseMoreThanTheFileHas)
{
    std::string png = kPng;
    png[33] = '\x40'; // the length of the second chunk: a gigabyte
    expect_refused(png, "t: the PNG picture is cut off or damaged at byte 33");
}

TEST(Texture, RefusesDamagedPpm)
{
    expect_refused("P6", "t: the picture's header lacks its width");
    expect_refused("P6 5", "t: the picture's header lacks its height");
    expect_refused("P6 1 1\n", "t: the picture's header lacks its largest value");
    expect_refused("P6 1 1 255", "t: the picture has 0 bytes of pixels instead of 3");
    expect_refused("P6 1 1 255 ab", "t: the picture has 2 bytes of pixels instead of 3");
    expect_refused("P6 1 1 0 abc", "t: the picture's largest value is 0, 1 to 65535 is accepted");
    expect_refused("P6 1 1 65536 abc", "t: the picture's largest value is 65536");
    expect_refused("P6 0 1 255 abc", "t: the picture is empty (0 x 1)");
}

TEST(Texture, RefusesPicturesThatAreTooLargeBeforeTheyTakeMemory)
{
    expect_refused("P6 16385 1 255 ", "t: a picture of 16385 x 1 is too large");
    expect_refused("P6 16384 16384 255 ", "t: a picture of 16384 x 16384 is too large");
    expect_refused("P6 99999999999999999999 9 255 ", "t: a picture of 1000000000 x 9 is too large");
    std::string png = kPng;
    png[18] = png[22] = '\x40'; // 16386 x 16386
    EXPECT_THROW(decode_texture("t", png), FileError);
}

TEST(MipLevels, HalveDownToOneTexel)
{
    const Texture texture = texture_of(8, 3, Texels(24, kWhite));
    ASSERT_EQ(texture.levels.size(), 4u);
    const int sizes[4][2] = {{8, 3}, {4, 1}, {2, 1}, {1, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(texture.levels[k].width, sizes[k][0]);
        EXPECT_EQ(texture.levels[k].height, sizes[k][1]);
        for (const std::uint32_t t : texture.levels[k].texel) EXPECT_EQ(t, kWhite);
    }
}

TEST(MipLevels, AverageInLinearLight)
{
    // Half the light of white is 188 in sRGB, not 128.
    EXPECT_EQ(texture_of(2, 1, {kBlack, kWhite}).levels[1].texel, Texels{0xFFBCBCBCu});
    EXPECT_EQ(texture_of(1, 2, {kBlack, kWhite}).levels[1].texel, Texels{0xFFBCBCBCu});
}

TEST(MipLevels, AverageAlphaAsItIs)
{
    EXPECT_EQ(texture_of(2, 1, {0x00FFFFFFu, kWhite}).levels[1].texel, Texels{0x80FFFFFFu});
}

TEST(MipLevels, ShareTexelsOfOddSizesByTheirAreas)
{
    // 5 wide: each of two covers 2.5 texels, the third one half each.
    const Texture texture = texture_of(5, 1, {kBlack, kBlack, kWhite, kWhite, kWhite});
    ASSERT_EQ(texture.levels[1].width, 2);
    const auto grey = [](double light) {
        return 0xFF000000u | 0x010101u * srgb_from_linear(static_cast<float>(light));
    };
    EXPECT_EQ(texture.levels[1].texel, (Texels{grey(0.5 / 2.5), kWhite}));
    EXPECT_EQ(texture.levels[2].texel, Texels{grey(3.0 / 5)}) << "the mean of all";
}

TEST(MipLevels, KeepTheMeanOfAnySize)
{
    for (const int width : {1, 2, 3, 5, 7, 12, 31})
        for (const int height : {1, 3, 6, 11}) {
            Texels texels;
            double light = 0;
            for (int k = 0; k < width * height; ++k) {
                const auto value = static_cast<std::uint32_t>((k * 37) % 256);
                texels.push_back(kBlack | value);
                light += double(linear_from_srgb()[value]) / (width * height);
            }
            const std::uint32_t last = texture_of(width, height, texels).levels.back().texel[0];
            EXPECT_NEAR(last & 255, srgb_from_linear(static_cast<float>(light)), 1);
        }
}

} // namespace
} // namespace firsthit
