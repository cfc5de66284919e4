// film_data_test.cpp - all planes in one file, read back by OpenEXR, and 8-bit pixels.
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/film_data.h>
#include <firsthit/scene.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartInputFile.h>
#include <gtest/gtest.h>

#include <limits>

namespace firsthit {
namespace {

constexpr int kWide = 5, kHigh = 3;

Film small_film()
{
    Film film;
    film.width = kWide;
    film.height = kHigh;
    const auto fill = [](Plane& plane, int channels, float first) {
        plane.channels = channels;
        for (int k = 0; k < kWide * kHigh * channels; ++k)
            plane.value.push_back(first + float(k) / 64);
    };
    fill(film.color, 3, 0.25f);
    fill(film[Aov::depth], 1, 2);
    fill(film[Aov::normal], 3, -1);
    fill(film[Aov::lit], 2, 7);
    film[Aov::depth].value[4] = std::numeric_limits<float>::infinity();
    for (std::uint32_t k = 0; k < kWide * kHigh; ++k) film.instance.push_back(16777217u + k);
    film.instance[3] = kNoItem;
    return film;
}

template <class T>
std::vector<T> channel_in(const std::string& path, const char* name)
{
    Imf::InputFile file(path.c_str());
    const Imf::PixelType type = std::is_same_v<T, float> ? Imf::FLOAT : Imf::UINT;
    const Imf::Channel* channel = file.header().channels().findChannel(name);
    if (!channel || channel->type != type) return {};
    std::vector<T> values(kWide * kHigh);
    Imf::FrameBuffer buffer;
    buffer.insert(name,
        Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(T), sizeof(T) * kWide));
    file.setFrameBuffer(buffer);
    file.readPixels(0, kHigh - 1);
    return values;
}

std::vector<float> values_of(const Plane& plane, int channel)
{
    std::vector<float> values;
    for (std::size_t k = std::size_t(channel); k < plane.value.size();
         k += std::size_t(plane.channels))
        values.push_back(plane.value[k]);
    return values;
}

TEST(WritePlanes, PutsEveryPlaneIntoOnePart)
{
    const TemporaryFolder folder;
    const std::string path = folder / "all.exr";
    const Film film = small_film();
    const std::vector<Aov> aovs = {Aov::instance, Aov::depth, Aov::normal, Aov::lit};
    write_planes(film, true, aovs, path);
    EXPECT_EQ(Imf::MultiPartInputFile(path.c_str()).parts(), 1);
    int channels = 0;
    const Imf::InputFile file(path.c_str());
    for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c)
        ++channels;
    EXPECT_EQ(channels, 3 + 1 + 1 + 3 + 2);
    EXPECT_EQ(channel_in<float>(path, "R"), values_of(film.color, 0));
    EXPECT_EQ(channel_in<float>(path, "B"), values_of(film.color, 2));
    EXPECT_EQ(channel_in<float>(path, "Z"), values_of(film[Aov::depth], 0));
    EXPECT_EQ(channel_in<float>(path, "N.Y"), values_of(film[Aov::normal], 1));
    EXPECT_EQ(channel_in<float>(path, "lit.1"), values_of(film[Aov::lit], 1));
    EXPECT_EQ(channel_in<std::uint32_t>(path, "instance"), film.instance);
    write_planes(film, false, std::vector{Aov::depth}, path);
    EXPECT_TRUE(channel_in<float>(path, "R").empty());
    EXPECT_EQ(channel_in<float>(path, "Z"), values_of(film[Aov::depth], 0));
}

TEST(WritePlanes, RefusesWhatItCannotWrite)
{
    const TemporaryFolder folder;
    const Film film = small_film();
    const std::vector<Aov> depth = {Aov::depth}, missing = {Aov::depth, Aov::uv};
    EXPECT_NE(message_of<ArgumentError>([&] {
        write_planes(film, true, depth, folder / "a.png");
    }).find("accepted is .exr"),
        std::string::npos);
    EXPECT_EQ(
        message_of<ArgumentError>([&] { write_planes(film, true, missing, folder / "a.exr"); }),
        "the film has no plane 'uv'");
    EXPECT_THROW(write_planes(film, false, {}, folder / "a.exr"), ArgumentError);
    EXPECT_THROW(write_planes(film, true, depth, folder / "none/a.exr"), FileError);
    EXPECT_THROW(check_planes_path(folder / "none/a.exr"), FileError);
    EXPECT_THROW(check_planes_path(folder / "a.npy"), ArgumentError);
    EXPECT_TRUE(folder.names().empty());
}

TEST(SrgbPixels, AreTheValuesOfTheStandard)
{
    Film film;
    film.width = 2;
    film.height = 1;
    film.color = {3, {0, 1, 0.5f, 0.0031308f, 2, -1}};
    // IEC 61966-2-1: 255 (1.055 0.5^(1/2.4) - 0.055) = 187.5, 255 12.92 0.0031308 = 10.3
    EXPECT_EQ(srgb_pixels(film, {}, false), (std::vector<std::uint8_t>{0, 255, 188, 10, 255, 0}));
    EXPECT_EQ(srgb_pixels(film, {.exposure_ev = 1}, false)[2], 255);
    EXPECT_THROW(srgb_pixels(Film{}), ArgumentError);
    EXPECT_THROW(srgb_pixels(film, {.exposure_ev = 1000}), ArgumentError);
}

} // namespace
} // namespace firsthit
