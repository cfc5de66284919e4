// texture_test.cpp - pictures as textures and their smaller levels.
#include "base/srgb.h"
#include "readers/image/image_file.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

constexpr std::uint32_t kBlack = 0xFF000000u;
constexpr std::uint32_t kWhite = 0xFFFFFFFFu;

using Texels = std::vector<std::uint32_t>;

/// The sRGB codes of a level.
Texels codes_of(const Texture& texture, int level = 0)
{
    Texels codes;
    for (int y = 0; y < texture.height(level); ++y)
        for (int x = 0; x < texture.width(level); ++x) {
            const glm::vec4 color = texture.color(level, x, y);
            const auto alpha = static_cast<std::uint32_t>(std::lround(255 * color.a));
            const auto code = [&](float light) { return std::uint32_t(srgb_from_linear(light)); };
            codes.push_back(code(color.r) | code(color.g) << 8 | code(color.b) << 16 | alpha << 24);
        }
    return codes;
}

Texture texture_of(int width, int height, Texels texels)
{
    return Texture("t", Picture{width, height, std::move(texels)});
}

Texels texels_of(const std::string& bytes)
{
    return codes_of(decode_texture("t", bytes));
}

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
    EXPECT_EQ(texture.name(), path.string());
    EXPECT_EQ(texture.levels(), 2);
}

void expect_refused(const std::string& bytes, const std::string& message)
{
    EXPECT_EQ(message_of<FileError>([&] { decode_texture("t", bytes); }).substr(0, message.size()),
        message);
}

TEST(Texture, RefusesWhatIsNoPicture)
{
    const std::string refused =
        "t: not a PNG, JPEG, WebP or binary PPM picture, or a damaged one (";
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

void expect_misfit(const std::vector<Picture>& levels, const std::string& message)
{
    EXPECT_EQ(message_of<ArgumentError>([&] { Texture("t", levels); }), "texture 't': " + message);
}

TEST(Texture, RefusesLevelsThatDoNotFit)
{
    expect_misfit({}, "there is no picture");
    expect_misfit(
        {{0, 1, {}}}, "0 x 1 texels, 1 to 16384 on a side and at most 67108864 are accepted");
    expect_misfit({{1 << 14, 1 << 13, {}}},
        "16384 x 8192 texels, 1 to 16384 on a side and at most 67108864 are accepted");
    expect_misfit({{2, 2, {1, 2, 3}}}, "level 0 has 3 pixels for 2 x 2");
    expect_misfit({{2, 2, Texels(4)}, {2, 1, Texels(2)}}, "level 1 is 2 x 1 instead of 1 x 1");
    expect_misfit({{1, 1, Texels(1)}, {1, 1, Texels(1)}},
        "2 levels, of which level 0 is the last that can be");
}

TEST(Texture, BeginsAnewAroundEachLevel)
{
    const Texture texture = texture_of(2, 1, {kBlack, kWhite});
    const Texel black{0, 0, 0, -32768}, white{-32768, -32768, -32768, -32768};
    const std::vector<Texel> row = {white, black, white, black};
    for (std::size_t y = 0; y < 3; ++y)
        EXPECT_TRUE(std::ranges::equal(texture.texels().subspan(4 * y, 4), row)) << y;
    ASSERT_EQ(texture.texels().size(), 12u + 9u);
    EXPECT_EQ(texture.first()[1], 12);
    EXPECT_EQ(texture.texels()[12], texture.texels()[20]);
}

TEST(Texture, KeepsEveryCodeApart)
{
    Texels codes;
    for (std::uint32_t code = 0; code < 256; ++code) codes.push_back(code * 0x1010101u);
    EXPECT_EQ(codes_of(texture_of(16, 16, codes)), codes);
}

TEST(Texture, TurnsUpsideDownWithItsBorder)
{
    Texture texture = texture_of(2, 3, {1, 2, 3, 4, 5, 6});
    texture.turn_upside_down();
    const Texture turned = texture_of(2, 3, {5, 6, 3, 4, 1, 2});
    EXPECT_TRUE(std::ranges::equal(texture.texels(), turned.texels()));
}

TEST(MipLevels, HalveDownToOneTexel)
{
    const Texture texture = texture_of(8, 3, Texels(24, kWhite));
    ASSERT_EQ(texture.levels(), 4);
    const int sizes[4][2] = {{8, 3}, {4, 1}, {2, 1}, {1, 1}};
    for (int k = 0; k < 4; ++k) {
        EXPECT_EQ(texture.width(k), sizes[k][0]);
        EXPECT_EQ(texture.height(k), sizes[k][1]);
    }
    for (const Texel& t : texture.texels()) EXPECT_EQ(t, (Texel{-32768, -32768, -32768, -32768}));
}

TEST(MipLevels, AverageInLinearLight)
{
    const glm::vec4 grey(0.5f, 0.5f, 0.5f, 1.0f);
    EXPECT_EQ(texture_of(2, 1, {kBlack, kWhite}).color(1, 0, 0), grey);
    EXPECT_EQ(texture_of(1, 2, {kBlack, kWhite}).color(1, 0, 0), grey);
}

TEST(MipLevels, AverageAlphaAsItIs)
{
    EXPECT_EQ(texture_of(2, 1, {0x00FFFFFFu, kWhite}).color(1, 0, 0), glm::vec4(1, 1, 1, 0.5f));
}

TEST(MipLevels, ShareTexelsOfOddSizesByTheirAreas)
{
    // 5 wide: each of two covers 2.5 texels, the third one half each.
    const Texture texture = texture_of(5, 1, {kBlack, kBlack, kWhite, kWhite, kWhite});
    ASSERT_EQ(texture.width(1), 2);
    EXPECT_NEAR(texture.color(1, 0, 0).r, 0.5 / 2.5, 2e-5);
    EXPECT_EQ(texture.color(1, 1, 0).r, 1);
    EXPECT_NEAR(texture.color(2, 0, 0).r, 3.0 / 5, 2e-5) << "the mean of all";
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
            const Texture texture = texture_of(width, height, texels);
            EXPECT_NEAR(texture.color(texture.levels() - 1, 0, 0).r, light, 3e-5);
        }
}

} // namespace
} // namespace firsthit
