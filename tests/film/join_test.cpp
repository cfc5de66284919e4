// join_test.cpp - tiles of every kind become the file that was written whole, and what is no cover is told.
#include "message_of.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/film_data.h>
#include <firsthit/join.h>
#include <firsthit/picture.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <vector>

namespace firsthit {
namespace {

constexpr int kWidth = 37, kHeight = 29;

/// A film of random values, or the part of it that a region has.
Film film_of(const Region& region, bool alpha = false)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(0, 1);
    Film film;
    film.width = region.width;
    film.height = region.height;
    film.color.channels = film[Aov::normal].channels = 3;
    film[Aov::depth].channels = 1;
    if (alpha) film.alpha.channels = 1;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float a = value(random), b = value(random), c = value(random);
            if (x < region.x || x >= region.x + region.width || y < region.y ||
                y >= region.y + region.height)
                continue;
            film.color.value.insert(film.color.value.end(), {0.4f * a, 0.4f * b, 0.4f * c});
            film[Aov::normal].value.insert(film[Aov::normal].value.end(), {b, c, a});
            film[Aov::depth].value.push_back(60 * a);
            film.item.push_back(static_cast<std::uint32_t>(4e9 * double(c)));
            if (alpha) film.alpha.value.push_back(0.5f + 0.5f * b);
        }
    return film;
}

const Region kWhole{0, 0, kWidth, kHeight};
/// In no order, with a corner that four tiles share and edges at no multiple of 8.
const std::vector<Region> kTiles{
    {13, 11, 24, 18}, {0, 0, 13, 11}, {0, 11, 13, 18}, {13, 0, 3, 11}, {16, 0, 21, 11}};

std::string bytes_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class Join : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    /// Writes the tiles by a function, joins them, and compares with the whole.
    template <class Write>
    void expect_whole(const std::string& ending, const Write& write)
    {
        std::vector<PictureTile> tiles;
        for (const Region& region : kTiles) {
            tiles.push_back({path("tile" + std::to_string(tiles.size()) + ending), region});
            write(region, tiles.back().path);
        }
        write(kWhole, path("whole" + ending));
        join_tiles(tiles, path("joined" + ending));
        EXPECT_GT(bytes_of(path("whole" + ending)).size(), 100u);
        EXPECT_EQ(bytes_of(path("joined" + ending)), bytes_of(path("whole" + ending))) << ending;
    }

    TemporaryFolder folder_;
};

TEST_F(Join, MakesThePicturesThatWereWrittenWhole)
{
    for (const bool alpha : {false, true})
        for (const bool dither : {false, true})
            for (const char* ending : {".png", ".exr"})
                expect_whole(ending, [&](const Region& region, const std::string& file) {
                    write_picture(film_of(region, alpha), file,
                        {.dither = dither, .origin = {region.x, region.y}});
                });
}

TEST_F(Join, MakesThePlanesThatWereWrittenWhole)
{
    for (const char* ending : {".png", ".exr", ".npy"})
        expect_whole(ending, [](const Region& region, const std::string& file) {
            write_aov(film_of(region), Aov::depth, file);
        });
    for (const Aov aov : {Aov::item, Aov::normal})
        for (const char* ending : {".exr", ".npy"})
            expect_whole(ending, [&](const Region& region, const std::string& file) {
                write_aov(film_of(region), aov, file);
            });
    const std::vector<Aov> planes{Aov::depth, Aov::item, Aov::normal};
    expect_whole(".exr", [&](const Region& region, const std::string& file) {
        write_planes(film_of(region), true, planes, file);
    });
}

TEST_F(Join, TakesOneTile)
{
    write_aov(film_of(kWhole), Aov::item, path("a.npy"));
    const PictureTile tile{path("a.npy"), kWhole};
    join_tiles(std::span(&tile, 1), path("b.npy"));
    EXPECT_EQ(bytes_of(path("a.npy")), bytes_of(path("b.npy")));
}

/// What joining tiles of these regions says.
template <class Error>
std::string said(const Join&, const std::string& folder, std::vector<Region> regions)
{
    std::vector<PictureTile> tiles;
    for (const Region& region : regions) {
        const std::string file = folder + std::to_string(tiles.size()) + ".npy";
        if (region.x >= 0) write_aov(film_of(region), Aov::depth, file);
        tiles.push_back({file, region});
    }
    return message_of<Error>([&] { join_tiles(tiles, folder + "out.npy"); });
}

TEST_F(Join, NamesThePixelThatIsMissingOrTwice)
{
    const std::string here = path("");
    const auto expect = [&](const std::vector<Region>& regions, const std::string& text) {
        const std::string message = said<ArgumentError>(*this, here, regions);
        EXPECT_NE(message.find(text), std::string::npos) << message;
    };
    expect({{1, 0, 5, 5}}, "no tile has pixel (0, 0)");
    expect({{0, 2, 5, 5}}, "no tile has pixel (0, 0)");
    expect({{0, 0, 5, 5}, {6, 0, 5, 5}}, "no tile has pixel (5, 0)");
    expect({{0, 0, 5, 5}, {5, 0, 5, 4}}, "no tile has pixel (5, 4)");
    expect({{0, 0, 5, 5}, {0, 6, 5, 5}}, "no tile has pixel (0, 5)");
    expect({{0, 0, 5, 5}, {4, 0, 5, 5}}, "both have pixel (4, 0)");
    expect({{0, 0, 5, 5}, {0, 4, 5, 5}}, "both have pixel (0, 4)");
    expect({{0, 0, 9, 9}, {3, 3, 2, 2}}, "both have pixel (3, 3)");
    expect({{0, 0, 4, 4}, {0, 0, 4, 4}}, "both have pixel (0, 0)");
    expect({{-1, 0, 4, 4}}, "is not in a picture");
    expect({}, "no tiles");
    EXPECT_FALSE(std::ifstream(path("out.npy")).good());
}

TEST_F(Join, NamesFilesThatDoNotFit)
{
    const Region left{0, 0, 5, 4}, right{5, 0, 5, 4};
    write_aov(film_of(left), Aov::depth, path("left.npy"));
    write_aov(film_of(right), Aov::normal, path("right.npy"));
    write_aov(film_of(right), Aov::item, path("item.npy"));
    write_aov(film_of(right), Aov::depth, path("right.exr"));
    write_picture(film_of(left), path("left.png"));
    write_picture(film_of(right, true), path("right.png"));
    std::ofstream(path("text.npy")) << "no array";
    std::ofstream(path("text.png")) << "no picture";
    std::ofstream(path("cut.npy"), std::ios::binary) << bytes_of(path("left.npy")).substr(0, 150);
    std::ofstream(path("cut.png"), std::ios::binary) << bytes_of(path("left.png")).substr(0, 60);
    const auto expect = [&](const PictureTile& a, const PictureTile& b, const std::string& text) {
        const std::vector<PictureTile> tiles{a, b};
        const std::string output = path("out" + a.path.substr(a.path.size() - 4));
        const std::string message = message_of<Error>([&] { join_tiles(tiles, output); });
        EXPECT_NE(message.find(text), std::string::npos) << message;
        EXPECT_FALSE(std::ifstream(output).good());
    };
    const auto tile = [&](const char* name, const Region& region) {
        return PictureTile{path(name), region};
    };
    expect(tile("left.npy", left), tile("right.npy", right), "is NumPy, 3 x <f4");
    expect(tile("left.npy", left), tile("item.npy", right), "is NumPy, <u4");
    expect(tile("left.npy", left), tile("right.exr", right), "different kinds");
    expect(tile("left.png", left), tile("right.png", right), "is PNG, 8 bits, RGBA");
    expect(tile("left.npy", {0, 0, 6, 4}), tile("right.npy", {6, 0, 5, 4}), "has 5x4 pixels");
    expect(tile("none.npy", left), tile("right.npy", right), "none.npy");
    expect(tile("text.npy", left), tile("right.npy", right), "text.npy");
    expect(tile("text.png", left), tile("right.png", right), "cannot be read as PNG");
    expect(tile("cut.npy", left), tile("right.npy", right), "cut.npy");
    expect(tile("cut.png", left), tile("right.png", right), "cut.png");
    expect(tile("a.jpg", left), tile("b.jpg", right), "accepted tiles are .png, .exr and .npy");
    const PictureTile one = tile("left.npy", left);
    EXPECT_NE(message_of<ArgumentError>([&] {
        join_tiles(std::span(&one, 1), path("out.png"));
    }).find("accepted is the tiles' ending"),
        std::string::npos);
}

} // namespace
} // namespace firsthit
