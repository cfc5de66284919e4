// text_numbers_test.cpp - numbers of text files are the nearest floats.
#include "readers/aff/aff_text.h"
#include "readers/mesh/mtl/mtl.h"
#include "readers/mesh/mesh_text.h"
#include "io/parse_number.h"
#include "io/scan_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace firsthit::test {
namespace {

std::uint32_t bits(float x)
{
    return std::bit_cast<std::uint32_t>(x);
}

/// strtof rounds rightly; tests run in the C locale.
float nearest(const std::string& word)
{
    return std::strtof(word.c_str(), nullptr);
}

class Words {
  public:
    /// 1 to 20 digits with a point anywhere, some with an exponent.
    std::string any()
    {
        const int digits = number(1, 20);
        std::string word;
        for (int k = 0; k < digits; ++k) word += static_cast<char>('0' + number(0, 9));
        if (number(0, 3) > 0) word.insert(std::size_t(number(0, digits)), ".");
        if (number(0, 2) == 0) word += "e" + std::to_string(number(-30, 12));
        return number(0, 1) ? word : "-" + word;
    }

    /// Next to the middle between two floats: what goes through double is rounded wrongly there.
    std::string near_middle()
    {
        const auto exponent = std::uint32_t(number(110, 140));
        const auto low = std::bit_cast<float>(exponent << 23 | std::uint32_t(number(0, 0x7FFFFE)));
        const double middle = (double(low) + double(std::nextafter(low, 1e9f))) / 2;
        char text[120];
        std::snprintf(text, sizeof text, "%.60f", middle); // all of its digits, then zeros
        std::string word = text;
        word.back() = static_cast<char>('0' + number(0, 1));
        return word;
    }

    /// A float's shortest form, which has to come back as the same float.
    std::string shortest()
    {
        const auto sign = std::uint32_t(number(0, 1)) << 31;
        const auto value = std::bit_cast<float>(sign | std::uint32_t(number(0, 0x7F7FFFFF)));
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, value).ptr;
        return {text, end};
    }

    std::vector<std::string> some(int count)
    {
        std::vector<std::string> words;
        for (int k = 0; k < count; ++k)
            words.push_back(k % 4 == 0 ? near_middle() : k % 4 == 1 ? shortest() : any());
        return words;
    }

  private:
    int number(int first, int last) { return std::uniform_int_distribution(first, last)(random_); }

    std::mt19937 random_{7};
};

TEST(TextNumbers, AreTheNearestFloats)
{
    for (const std::string& word : Words().some(200'000))
        ASSERT_EQ(bits(parse_float(word).value()), bits(nearest(word))) << word;
}

TEST(TextNumbers, GoToZeroAndInfinityWhereFloatsEnd)
{
    EXPECT_EQ(parse_float("3.40282347e+38"), std::numeric_limits<float>::max());
    EXPECT_EQ(parse_float("3.4e-39"), 3.4e-39f);
    EXPECT_EQ(parse_float("7.1e-46"), std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(bits(parse_float("1e-50").value()), bits(0.0f));
    EXPECT_EQ(bits(parse_float("-1e-50").value()), bits(-0.0f));
    EXPECT_TRUE(std::isinf(parse_float("1e39").value()));
    EXPECT_TRUE(std::isinf(parse_float("-3.5e38").value()));
    EXPECT_FALSE(parse_float("1x"));
}

TEST(TextNumbers, OfLongTextsAreThoseOfWords)
{
    for (const std::string& word : Words().some(300'000)) {
        const std::string text = word + "\n";
        float value = 0;
        ASSERT_EQ(
            scan_float(text.data(), text.data() + text.size(), value), text.data() + word.size())
            << word;
        ASSERT_EQ(bits(value), bits(parse_float(word).value())) << word;
    }
    for (const std::string word :
        {"0", "-0", "+1", "1.", ".5", "-.5e1", "1e", "1e+", "e5", ".", "-", "", "1.2.3", "1,5",
            "0x10", "nan", "-inf", "1e38", "1e39", "123456789012345678901234567890",
            "0.00000000000000000000000000000000000001", "1e-38", "16777217", "16777219", "1e22",
            "9007199254740993", "1e0001", "1e00001", "00000000000000000000001", "1_"}) {
        float value = -7;
        const char* const end = word.data() + word.size();
        const bool known = scan_float(word.data(), end, value) == end;
        const std::optional<float> expected = parse_float(word);
        ASSERT_EQ(known && !word.empty(), expected.has_value()) << word;
        if (!expected || std::isnan(*expected)) continue;
        EXPECT_EQ(bits(value), bits(*expected)) << word;
    }
}

/// What a format makes of three numbers, at the first corner.
using Reads = Scene (*)(const std::string& x, const std::string& y, const std::string& z);

void expect_nearest(Reads reads)
{
    const std::vector<std::string> words = Words().some(1500);
    for (std::size_t k = 0; k < words.size(); k += 3) {
        const Scene scene = reads(words[k], words[k + 1], words[k + 2]);
        const glm::vec3 p = scene.position[scene.index[0].x];
        for (int axis = 0; axis < 3; ++axis) {
            const std::string& word = words[k + std::size_t(axis)];
            ASSERT_EQ(p[axis], nearest(word)) << word;
        }
    }
}

TEST(TextNumbers, OfObjFiles)
{
    expect_nearest([](const std::string& x, const std::string& y, const std::string& z) {
        return read("v " + x + " " + y + " " + z + "\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", ".obj");
    });
}

TEST(TextNumbers, OfPlyFiles)
{
    expect_nearest([](const std::string& x, const std::string& y, const std::string& z) {
        return read(
            ply_header("ascii", "3", "1") + x + " " + y + " " + z + "\n0 1 0\n0 0 1\n3 0 1 2\n",
            ".ply");
    });
}

TEST(TextNumbers, OfStlFiles)
{
    expect_nearest([](const std::string& x, const std::string& y, const std::string& z) {
        return read("solid\nfacet normal 0 0 0\nouter loop\nvertex " + x + " " + y + " " + z +
                        "\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid\n",
            ".stl");
    });
}

TEST(TextNumbers, OfAffFiles)
{
    expect_nearest([](const std::string& x, const std::string& y, const std::string& z) {
        return scene_of("p 3 " + x + " " + y + " " + z + " 0 1 0 0 0 1");
    });
}

TEST(TextNumbers, OfTextureCoordinates)
{
    for (const std::string& word : Words().some(500)) {
        const std::string obj = "v 0 0 0\nv 0 1 0\nv 0 0 1\nvt " + word + " 0\nf 1/1 2/1 3/1\n";
        const Scene scene = read(obj, ".obj");
        ASSERT_EQ(scene.uv[0].x, nearest(word)) << word;
    }
}

TEST(TextNumbers, OfMaterials)
{
    for (const std::string& word : Words().some(500)) {
        Problems problems;
        const auto materials = read_mtl("newmtl a\nKd " + word + " 0 0\n", "m.mtl", problems);
        ASSERT_EQ(materials.at(0).phong.diffuse.r, nearest(word)) << word;
    }
}

TEST(TextNumbers, OfLights)
{
    for (const std::string& word : Words().some(500)) {
        const Scene scene = scene_of("l 1 2 3 " + word + " 0 0");
        ASSERT_EQ(scene.lights.at(0).color.r, nearest(word)) << word;
    }
}

} // namespace
} // namespace firsthit::test
