// picture_files_test.cpp - what is written is read back by the formats' own libraries.
#include "base/srgb.h"

#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/film.h>
#include <firsthit/scene.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace firsthit {
namespace {

constexpr int kNumberedLights = 12;

/// A film with all planes, each value different.
Film numbered_film(int width, int height)
{
    Film film;
    film.width = width;
    film.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const auto fill = [&](Plane& plane, int channels, float start) {
        plane.channels = channels;
        for (std::size_t k = 0; k < pixels * static_cast<std::size_t>(channels); ++k)
            plane.value.push_back(start + static_cast<float>(k));
    };
    fill(film.color, 3, 0.0f);
    for (float& value : film.color.value) value /= static_cast<float>(3 * pixels);
    for (int a = 1; a < kAovCount; ++a)
        fill(film.aov[static_cast<std::size_t>(a)],
            Aov(a) == Aov::lit ? kNumberedLights : aov_channels(static_cast<Aov>(a)),
            0.5f + 1000.0f * static_cast<float>(a));
    for (std::size_t k = 0; k < pixels; ++k) film.item.push_back(static_cast<std::uint32_t>(k));
    film.item[0] = kNoItem;
    film[Aov::depth].value[0] = std::numeric_limits<float>::infinity();
    return film;
}

struct ReadPng {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

ReadPng read_png(const std::string& path)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&image, path.c_str())) << image.message;
    EXPECT_EQ(image.format, unsigned(PNG_FORMAT_RGB));
    ReadPng read;
    read.width = static_cast<int>(image.width);
    read.height = static_cast<int>(image.height);
    read.rgb.resize(PNG_IMAGE_SIZE(image));
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, read.rgb.data(), 0, nullptr))
        << image.message;
    return read;
}

/// One channel of an EXR, of the type expected.
template <class T>
std::vector<T> read_channel(const std::string& path, const char* name)
{
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    const std::size_t width = static_cast<std::size_t>(box.max.x - box.min.x + 1);
    const std::size_t height = static_cast<std::size_t>(box.max.y - box.min.y + 1);
    const Imf::PixelType type = std::is_same_v<T, float> ? Imf::FLOAT : Imf::UINT;
    const Imf::Channel* channel = file.header().channels().findChannel(name);
    EXPECT_TRUE(channel) << name;
    if (!channel) return {};
    EXPECT_EQ(channel->type, type);
    std::vector<T> values(width * height);
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(values.data()), 4, 4 * width));
    file.setFrameBuffer(buffer);
    file.readPixels(box.min.y, box.max.y);
    return values;
}

/// Channel c of interleaved values.
std::vector<float> channel_of(const Plane& plane, int c)
{
    std::vector<float> values;
    for (std::size_t k = static_cast<std::size_t>(c); k < plane.value.size();
         k += static_cast<std::size_t>(plane.channels))
        values.push_back(plane.value[k]);
    return values;
}

struct ReadNpy {
    std::string header;
    std::string data;
};

ReadNpy read_npy(const std::string& path)
{
    const std::string bytes = bytes_of(path);
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length =
        static_cast<std::uint8_t>(bytes[8]) + 256u * static_cast<std::uint8_t>(bytes[9]);
    EXPECT_EQ((10 + length) % 64, 0u);
    EXPECT_EQ(bytes[10 + length - 1], '\n');
    return {bytes.substr(10, length), bytes.substr(10 + length)};
}

template <class T>
std::string raw(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

TEST(Png, HasTheRoundedSrgbOfEveryValueFromTheTopRow)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(37, 23);
    write_color(film, folder / "a.png");
    const ReadPng read = read_png(folder / "a.png");
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 23);
    ASSERT_EQ(read.rgb.size(), film.color.value.size());
    for (std::size_t k = 0; k < read.rgb.size(); ++k)
        ASSERT_EQ(read.rgb[k], srgb_from_linear(film.color.value[k]));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.png"});
}

TEST(Png, AnEndingMayBeInCapitals)
{
    const TemporaryFolder folder;
    write_color(numbered_film(2, 2), folder / "a.PNG");
    EXPECT_EQ(read_png(folder / "a.PNG").width, 2);
}

TEST(Png, SeveralMegapixelsComeBack)
{
    const TemporaryFolder folder;
    Film film = numbered_film(4096, 1200);
    write_color(film, folder / "a.png");
    const ReadPng read = read_png(folder / "a.png");
    EXPECT_EQ(read.rgb.back(), srgb_from_linear(film.color.value.back()));
}

TEST(Exr, HasTheColourAsFloats)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(37, 23);
    write_color(film, folder / "a.exr");
    EXPECT_EQ(read_channel<float>(folder / "a.exr", "R"), channel_of(film.color, 0));
    EXPECT_EQ(read_channel<float>(folder / "a.exr", "G"), channel_of(film.color, 1));
    EXPECT_EQ(read_channel<float>(folder / "a.exr", "B"), channel_of(film.color, 2));
}

TEST(Exr, HasItemsAsUnsignedIntegers)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(19, 17);
    write_aov(film, Aov::item, folder / "a.exr");
    EXPECT_EQ(read_channel<std::uint32_t>(folder / "a.exr", "item"), film.item);
}

TEST(Exr, HasEveryPlaneUnderTheDocumentedChannelNames)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(19, 17);
    const std::vector<std::pair<Aov, std::vector<const char*>>> names = {
        {Aov::depth, {"Z"}},
        {Aov::distance, {"distance"}},
        {Aov::uv, {"U", "V"}},
        {Aov::normal, {"N.X", "N.Y", "N.Z"}},
        {Aov::geometric_normal, {"Ng.X", "Ng.Y", "Ng.Z"}},
        {Aov::position, {"P.X", "P.Y", "P.Z"}},
        {Aov::albedo, {"albedo.R", "albedo.G", "albedo.B"}},
        {Aov::barycentric, {"barycentric.U", "barycentric.V"}},
        {Aov::tangent, {"T.X", "T.Y", "T.Z", "T.W"}},
        {Aov::metallic_roughness, {"metallic", "roughness"}},
        {Aov::emission, {"emission.R", "emission.G", "emission.B"}},
        {Aov::motion, {"motion.X", "motion.Y"}},
        {Aov::motion_visible, {"motion_visible"}},
        {Aov::normal_camera, {"Nc.X", "Nc.Y", "Nc.Z"}},
        {Aov::position_camera, {"Pc.X", "Pc.Y", "Pc.Z"}},
        {Aov::lit, {"lit.0", "lit.1", "lit.2", "lit.3", "lit.4", "lit.5", "lit.6", "lit.7", "lit.8",
                       "lit.9", "lit.10", "lit.11"}},
    };
    for (const auto& [aov, channels] : names) {
        write_aov(film, aov, folder / "a.exr");
        for (std::size_t c = 0; c < channels.size(); ++c)
            EXPECT_EQ(read_channel<float>(folder / "a.exr", channels[c]),
                channel_of(film[aov], static_cast<int>(c)))
                << channels[c];
    }
}

TEST(Npy, HasItemsAsUnsignedIntegersWithNoneAtTheTop)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(5, 3);
    write_aov(film, Aov::item, folder / "a.npy");
    const ReadNpy read = read_npy(folder / "a.npy");
    EXPECT_EQ(read.header.find("{'descr': '<u4', 'fortran_order': False, 'shape': (3, 5), }"), 0u);
    EXPECT_EQ(read.data, raw(film.item));
    EXPECT_EQ(read.data.substr(0, 4), "\xFF\xFF\xFF\xFF");
}

TEST(Npy, HasOneChannelAsTwoDimensions)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(5, 3);
    write_aov(film, Aov::depth, folder / "a.npy");
    const ReadNpy read = read_npy(folder / "a.npy");
    EXPECT_EQ(read.header.find("{'descr': '<f4', 'fortran_order': False, 'shape': (3, 5), }"), 0u);
    EXPECT_EQ(read.data, raw(film[Aov::depth].value));
}

TEST(Npy, HasMoreChannelsAsThreeDimensions)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(5, 3);
    write_aov(film, Aov::uv, folder / "a.npy");
    const ReadNpy read = read_npy(folder / "a.npy");
    EXPECT_NE(read.header.find("'shape': (3, 5, 2)"), std::string::npos);
    EXPECT_EQ(read.data, raw(film[Aov::uv].value));
}

TEST(Npy, HasLightAsTwoDimensionsWhereThereIsOneLight)
{
    const TemporaryFolder folder;
    Film film = numbered_film(5, 3);
    write_aov(film, Aov::lit, folder / "a.npy");
    EXPECT_NE(read_npy(folder / "a.npy").header.find("'shape': (3, 5, 12)"), std::string::npos);
    film[Aov::lit].channels = 1;
    film[Aov::lit].value.resize(15);
    write_aov(film, Aov::lit, folder / "a.npy");
    const ReadNpy read = read_npy(folder / "a.npy");
    EXPECT_NE(read.header.find("'shape': (3, 5), "), std::string::npos);
    EXPECT_EQ(read.data, raw(film[Aov::lit].value));
}

TEST(PictureFiles, LightOfMoreThan64LightsIsAnError)
{
    Film film;
    film.width = film.height = 1;
    film[Aov::lit] = {65, std::vector<float>(65, 1.0f)};
    EXPECT_EQ(message_of<ArgumentError>([&] { write_aov(film, Aov::lit, "a.npy"); }),
        "the film's plane 'lit' has 65 lights: accepted are 1 to 64");
    film[Aov::lit] = {0, {1.0f}};
    EXPECT_THROW(write_aov(film, Aov::lit, "a.npy"), ArgumentError);
    film[Aov::lit] = {2, {}};
    EXPECT_EQ(message_of<ArgumentError>([&] { write_aov(film, Aov::lit, "a.npy"); }),
        "the film has no plane 'lit'");
}

TEST(PictureFiles, AnUnknownEndingIsAnErrorThatListsTheAccepted)
{
    const Film film = numbered_film(2, 2);
    EXPECT_EQ(message_of<Error>([&] {
        write_color(film, "a.bmp");
    }).find("a.bmp: unknown ending '.bmp' for a picture: accepted are .png, "),
        0u);
    EXPECT_EQ(message_of<Error>([&] { write_aov(film, Aov::depth, "a.tif"); }),
        "a.tif: unknown ending '.tif' for a plane: accepted are .exr and .npy, and .png for depth "
        "and "
        "distance");
    EXPECT_EQ(message_of<Error>([&] { write_aov(film, Aov::uv, "a.png"); }),
        "a.png: the plane 'uv' is not written as .png, which is for depth and distance in "
        "millimetres: "
        "accepted are .exr and .npy");
    EXPECT_THROW(write_color(film, "picture"), ArgumentError);
    EXPECT_THROW(check_color_path("a.npy"), ArgumentError);
    EXPECT_THROW(check_aov_path("a"), ArgumentError);
}

TEST(PictureFiles, APlaneTheFilmLacksIsAnError)
{
    Film film;
    film.width = film.height = 2;
    EXPECT_EQ(
        message_of<Error>([&] { write_color(film, "a.png"); }), "the film has no plane 'color'");
    EXPECT_EQ(message_of<Error>([&] { write_aov(film, Aov::item, "a.npy"); }),
        "the film has no plane 'item'");
}

TEST(PictureFiles, APlaneOfAnotherSizeIsAnError)
{
    Film film = numbered_film(4, 3);
    film.height = 2;
    EXPECT_EQ(message_of<Error>([&] { write_aov(film, Aov::uv, "a.npy"); }),
        "the film's plane 'uv' has 24 values, not 2 x 4 x 2");
    EXPECT_THROW(write_color(film, "a.png"), ArgumentError);
}

TEST(PictureFiles, EveryFormatReportsAFullDisk)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(64, 64);
    for (const char* name : {"full.png", "full.exr", "full.npy"})
        std::filesystem::create_symlink("/dev/full", folder / name);
    const std::string reason = ": cannot write: No space left on device";
    EXPECT_EQ(message_of<Error>([&] { write_color(film, folder / "full.png"); }),
        (folder / "full.png") + reason);
    EXPECT_EQ(message_of<Error>([&] { write_color(film, folder / "full.exr"); }),
        (folder / "full.exr") + reason);
    EXPECT_EQ(message_of<Error>([&] { write_aov(film, Aov::position, folder / "full.npy"); }),
        (folder / "full.npy") + reason);
    EXPECT_EQ(message_of<Error>([&] { write_color(film, "/dev/full"); }), "/dev/full" + reason);
    EXPECT_EQ(
        message_of<Error>([&] { write_aov(film, Aov::item, "/dev/full"); }), "/dev/full" + reason);
}

TEST(PictureFiles, ADiskThatFillsUpLaterIsReportedByEveryFormat)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(1500, 1000); // more than one buffer in each format
    for (const char* name : {"full.png", "full.exr", "full.npy"})
        std::filesystem::create_symlink("/dev/full", folder / name);
    EXPECT_THROW(write_color(film, folder / "full.png"), FileError);
    EXPECT_THROW(write_color(film, folder / "full.exr"), FileError);
    EXPECT_THROW(write_aov(film, Aov::position, folder / "full.npy"), FileError);
}

TEST(PictureFiles, APipeTakesWhatIsWrittenInOneGoAndExrReportsThatItCannotGoBack)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(8, 8);
    for (const char* name : {"pipe.png", "pipe.exr"}) mkfifo((folder / name).c_str(), 0600);
    // Open for reading too, so that opening for writing does not wait.
    const int png = open((folder / "pipe.png").c_str(), O_RDWR);
    const int exr = open((folder / "pipe.exr").c_str(), O_RDWR);
    write_color(film, folder / "pipe.png");
    EXPECT_EQ(message_of<Error>([&] { write_color(film, folder / "pipe.exr"); }),
        (folder / "pipe.exr") + ": cannot write: Illegal seek");
    close(png);
    close(exr);
}

TEST(PictureFiles, EveryFormatGoesToTheNullDevice)
{
    const Film film = numbered_film(8, 8);
    write_color(film, "/dev/null");
    write_aov(film, Aov::normal, "/dev/null");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(PictureFiles, AMissingFolderLeavesNothing)
{
    const TemporaryFolder folder;
    const Film film = numbered_film(8, 8);
    EXPECT_THROW(write_color(film, folder / "none/a.png"), FileError);
    EXPECT_THROW(write_color(film, folder / "none/a.exr"), FileError);
    EXPECT_THROW(write_aov(film, Aov::depth, folder / "none/a.npy"), FileError);
    EXPECT_THROW(check_color_path(folder / "none/a.png"), FileError);
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace firsthit
