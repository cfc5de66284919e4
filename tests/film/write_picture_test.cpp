// write_picture_test.cpp - transparency, dithering, JPEG, WebP and depths in millimetres, read back by other
// decoders.
#include "readers/image/image_file.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/picture.h>

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdio>
#include <limits>

namespace firsthit {
namespace {

/// The definition of IEC 61966-2-1, in double precision.
double light_of_code(int code)
{
    const double s = code / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

int nearest_code(double light)
{
    const double s = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return int(std::floor(255 * s + 0.5));
}

Film flat_film(int width, int height, float value)
{
    Film film;
    film.width = width;
    film.height = height;
    film.color = {3, std::vector<float>(std::size_t(width) * std::size_t(height) * 3, value)};
    return film;
}

Picture picture_of(const std::string& path)
{
    return decode_picture(path, bytes_of(path));
}

int channel(std::uint32_t pixel, int c)
{
    return int(pixel >> (8 * c) & 255);
}

TEST(Dither, TheMeanLightOfAFlatRegionIsRight)
{
    const TemporaryFolder folder;
    for (const float value : {0.001f, 0.0123f, 0.2f, 0.5f, 0.73f, 0.999f}) {
        write_picture(flat_film(16, 16, value), folder / "a.png");
        const Picture picture = picture_of(folder / "a.png");
        double mean = 0;
        int least = 255, most = 0;
        for (const std::uint32_t pixel : picture.pixel) {
            mean += light_of_code(channel(pixel, 0)) / 256;
            least = std::min(least, channel(pixel, 0));
            most = std::max(most, channel(pixel, 0));
            EXPECT_EQ(channel(pixel, 0), channel(pixel, 2)) << "grey stays grey";
        }
        EXPECT_LE(most - least, 1);
        const double step = light_of_code(least + 1) - light_of_code(least);
        EXPECT_NEAR(mean, double(value), step / 64) << value;
    }
}

TEST(Dither, ChangesNoValueThatIsACodesOwn)
{
    const TemporaryFolder folder;
    Film film = flat_film(64, 256, 0);
    for (std::size_t k = 0; k < film.color.value.size(); ++k)
        film.color.value[k] = float(light_of_code(int(k / 3 / 64)));
    write_picture(film, folder / "a.png");
    const Picture picture = picture_of(folder / "a.png");
    for (std::size_t k = 0; k < picture.pixel.size(); ++k)
        ASSERT_EQ(channel(picture.pixel[k], 1), int(k / 64));
}

TEST(Dither, LeavesWhatIsOutOfRangeFlat)
{
    const TemporaryFolder folder;
    for (const float value : {-1.0f, 0.0f, 1.0f, 7.0f, std::numeric_limits<float>::infinity(),
             -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        write_picture(flat_film(16, 16, value), folder / "a.png");
        for (const std::uint32_t pixel : picture_of(folder / "a.png").pixel)
            ASSERT_EQ(channel(pixel, 0), value >= 1 ? 255 : 0) << value;
    }
}

TEST(Dither, OffIsTheNearestCode)
{
    const TemporaryFolder folder;
    write_picture(flat_film(9, 9, 0.3f), folder / "a.png", {.dither = false});
    for (const std::uint32_t pixel : picture_of(folder / "a.png").pixel)
        EXPECT_EQ(channel(pixel, 0), nearest_code(double(0.3f)));
}

/// Pixels that are covered by 0 to 16 of 16 samples of a surface of one colour, before black.
Film covered_film()
{
    Film film = flat_film(17, 1, 0);
    film.alpha.channels = 1;
    for (int k = 0; k <= 16; ++k) {
        film.alpha.value.push_back(float(k) / 16);
        const float color[] = {0.8f, 0.25f, 0.5f};
        for (int c = 0; c < 3; ++c)
            film.color.value[std::size_t(3 * k + c)] = color[c] * float(k) / 16;
    }
    return film;
}

TEST(Alpha, OfPngAndWebpIsStraight)
{
    const TemporaryFolder folder;
    std::vector<std::string> endings = {"png"};
    for (const std::string& ending : picture_endings())
        if (ending == ".webp") endings.emplace_back("webp");
    for (const std::string& ending : endings) {
        const std::string path = folder / ("a." + ending);
        write_picture(covered_film(), path, {.dither = false, .quality = 100});
        const Picture picture = picture_of(path);
        ASSERT_EQ(picture.pixel.size(), 17u);
        EXPECT_EQ(channel(picture.pixel[0], 3), 0);
        for (int k = 1; k <= 16; ++k) {
            const std::uint32_t pixel = picture.pixel[std::size_t(k)];
            EXPECT_EQ(channel(pixel, 3), int(std::floor(255.0 * k / 16 + 0.5)));
            EXPECT_EQ(channel(pixel, 0), nearest_code(double(0.8f)));
            EXPECT_EQ(channel(pixel, 1), nearest_code(0.25));
            EXPECT_EQ(channel(pixel, 2), nearest_code(0.5));
        }
    }
}

TEST(Alpha, HasNoPlaceInJpeg)
{
    EXPECT_NE(
        message_of<ArgumentError>([] { write_picture(covered_film(), "a.jpg"); }).find("a.jpg: "),
        std::string::npos);
}

TEST(LayOver, AGradientStandsBehindWhatIsSeen)
{
    Film film = flat_film(2, 4, 0.25f);
    film.alpha = {1, {0, 0.5f, 0, 0.5f, 0, 0.5f, 0, 0.5f}};
    lay_over(film, {.top = {1, 0, 0}, .bottom = {0, 0, 1}}, 4, 8);
    EXPECT_TRUE(film.alpha.empty());
    for (int y = 0; y < 4; ++y) {
        const float down = (4 + float(y) + 0.5f) / 8;
        const float* const row = &film.color.value[std::size_t(6 * y)];
        EXPECT_FLOAT_EQ(row[0], 0.25f + 1 - down);
        EXPECT_FLOAT_EQ(row[1], 0.25f);
        EXPECT_FLOAT_EQ(row[2], 0.25f + down);
        EXPECT_FLOAT_EQ(row[3], 0.25f + 0.5f * (1 - down));
    }
    EXPECT_EQ(message_of<ArgumentError>([&] { lay_over(film, {}, 0, 4); }),
        "the film has no plane 'alpha'");
    EXPECT_THROW(lay_over(film, {.top = {-1, 0, 0}}, 0, 4), ArgumentError);
    EXPECT_THROW(lay_over(film, {.top = {NAN, 0, 0}}, 0, 4), ArgumentError);
}

TEST(Jpeg, IsNearTheColours)
{
    const std::vector<std::string> endings = picture_endings();
    if (std::find(endings.begin(), endings.end(), ".jpg") == endings.end())
        GTEST_SKIP() << "this build has no libjpeg";
    const TemporaryFolder folder;
    Film film = flat_film(64, 48, 0);
    for (std::size_t k = 0; k < film.color.value.size(); ++k)
        film.color.value[k] = float(k / 3 % 64) / 64 * (k % 3 == 1 ? 0.5f : 1.0f);
    for (const char* name : {"a.jpg", "b.JPEG"}) {
        write_picture(film, folder / name, {.quality = 98});
        const Picture picture = picture_of(folder / name);
        ASSERT_EQ(picture.width, 64);
        ASSERT_EQ(picture.height, 48);
        for (std::size_t k = 0; k < picture.pixel.size(); ++k)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(channel(picture.pixel[k], c),
                    nearest_code(double(film.color.value[3 * k + std::size_t(c)])), 5);
    }
    write_picture(film, folder / "small.jpg", {.quality = 20});
    EXPECT_LT(bytes_of(folder / "small.jpg").size(), bytes_of(folder / "a.jpg").size());
}

TEST(Jpeg, InMemoryIsTheFile)
{
    const std::vector<std::string> endings = picture_endings();
    if (std::find(endings.begin(), endings.end(), ".jpg") == endings.end())
        GTEST_SKIP() << "this build has no libjpeg";
    const TemporaryFolder folder;
    Film film = flat_film(40, 30, 0);
    for (std::size_t k = 0; k < film.color.value.size(); ++k)
        film.color.value[k] = float(k % 97) / 97;
    std::vector<std::uint8_t> rgba;
    for (std::size_t k = 0; k < film.color.value.size(); ++k) {
        rgba.push_back(static_cast<std::uint8_t>(nearest_code(double(film.color.value[k]))));
        if (k % 3 == 2) rgba.push_back(7); // an alpha that nobody looks at
    }
    for (const int quality : {50, 95}) {
        write_picture(film, folder / "a.jpg", {.dither = false, .quality = quality});
        EXPECT_EQ(encode_jpeg(rgba, 40, 30, quality), bytes_of(folder / "a.jpg")) << quality;
    }
    EXPECT_THROW(encode_jpeg(rgba, 40, 29, 90), ArgumentError);
    EXPECT_THROW(encode_jpeg(rgba, 40, 30, 0), ArgumentError);
    EXPECT_THROW(encode_jpeg(rgba, 40, 30, 101), ArgumentError);
    EXPECT_THROW(encode_jpeg({}, 0, 0, 90), ArgumentError);
    EXPECT_THROW(encode_jpeg({}, 65501, 0, 90), ArgumentError);
}

TEST(Webp, WithoutLossIsThePng)
{
    const std::vector<std::string> endings = picture_endings();
    if (std::find(endings.begin(), endings.end(), ".webp") == endings.end())
        GTEST_SKIP() << "this build has no libwebp";
    const TemporaryFolder folder;
    Film film = flat_film(50, 30, 0);
    for (std::size_t k = 0; k < film.color.value.size(); ++k)
        film.color.value[k] = float(k % 977) / 977;
    write_picture(film, folder / "a.webp", {.quality = 100});
    write_picture(film, folder / "a.png");
    EXPECT_EQ(picture_of(folder / "a.webp").pixel, picture_of(folder / "a.png").pixel);
    EXPECT_THROW(write_picture(flat_film(16384, 1, 0), folder / "b.webp"), FileError);
}

TEST(Picture, WhatCannotBeIsRefusedWithWhatIsAccepted)
{
    const Film film = flat_film(2, 2, 0);
    for (const int quality : {0, 101, -5})
        EXPECT_EQ(
            message_of<ArgumentError>([&] { write_picture(film, "a.png", {.quality = quality}); }),
            "quality " + std::to_string(quality) + " is out of range: 1 to 100");
    EXPECT_THROW(write_picture(film, "-"), ArgumentError) << "no format";
    EXPECT_THROW(check_picture_path("a.png", {.format = ".bmp"}), ArgumentError);
    EXPECT_NO_THROW(check_picture_path("-", {.format = ".png"}));
    EXPECT_THROW(check_plane_path(Aov::uv, "-", ".png"), ArgumentError);
    EXPECT_NO_THROW(check_plane_path(Aov::depth, "-", ".png"));
}

/// A grey PNG of 16 bits by libpng's own functions.
std::vector<int> read_gray(const std::string& path)
{
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    EXPECT_EQ(png_get_bit_depth(png, info), 16);
    EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
    std::vector<int> values;
    for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y)
        for (png_uint_32 x = 0; x < png_get_image_width(png, info); ++x) {
            const png_bytep at = png_get_rows(png, info)[y] + 2 * x;
            values.push_back(at[0] * 256 + at[1]);
        }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return values;
}

TEST(DepthPng, HasMillimetresAndNothingWhereNothingIsSeen)
{
    const TemporaryFolder folder;
    Film film;
    film.width = 5;
    film.height = 2;
    const float inf = std::numeric_limits<float>::infinity();
    film[Aov::depth] = {1, {inf, 1.0f, 0.0001f, 12.3456f, 65.535f, 65.6f, 1e9f, 0.0026f, 2, inf}};
    EXPECT_EQ(write_aov(film, Aov::depth, folder / "d.png"), 2u) << "two are too far";
    EXPECT_EQ(read_gray(folder / "d.png"),
        (std::vector<int>{0, 1000, 1, 12346, 65535, 65535, 65535, 3, 2000, 0}));
    EXPECT_EQ(write_aov(film, Aov::depth, folder / "d.npy"), 0u);
}

} // namespace
} // namespace firsthit
