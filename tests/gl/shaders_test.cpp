// shaders_test.cpp - every shader in every variant is accepted by glslangValidator.
#include "gl/device/program.h"
#include "gl/device/shader_texts.h"
#include "material/models.h"

#include <firsthit/film.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace firsthit {
namespace {

struct Variant {
    std::string shader;
    gl::Defines defines;
};

/// All variants that the library compiles. A new shader or define needs a line here.
std::vector<Variant> all_variants()
{
    std::vector<Variant> variants = {{"certify.vert", {}}, {"scatter.vert", {}},
        {"scatter.frag", {}}, {"certify.geom", {}}, {"certify.frag", {{"DOUBTS", "0"}}},
        {"certify.frag", {{"DOUBTS", "1"}}}, {"item.vert", {{"COLORS", "0"}}},
        {"item.frag", {{"COLORS", "0"}}}, {"item.frag", {{"COLORS", "1"}}},
        {"pose.comp", {{"SURFACES", "0"}}}, {"pose.comp", {{"SURFACES", "1"}}}, {"screen.vert", {}},
        {"shadow_depth.vert", {}}, {"shadow_depth.frag", {}}, {"store_map.comp", {}},
        {"count_samples.comp", {{"FIRSTHIT_COUNT_HITS", "0"}, {"FIRSTHIT_STORED_HITS", ""}}},
        {"count_samples.comp", {{"FIRSTHIT_COUNT_HITS", "1"}, {"FIRSTHIT_STORED_HITS", ""}}},
        {"average.frag", {}}, {"fill_holes.frag", {}}};
    // Every value of each define, and combinations of defines that affect the same code.
    const auto add = [&](const std::string& shader, int test, int channels, bool on, int plane,
                         int model = -1) {
        const std::string flag = on ? "1" : "0";
        gl::Defines defines = {{"FIRSTHIT_TEST", std::to_string(test)},
            {"FIRSTHIT_ITEM_CHANNELS", std::to_string(channels)}, {"FIRSTHIT_SHADOW_MAPS", flag},
            {"FIRSTHIT_TEXTURES", flag}, {"FIRSTHIT_SECOND_UV", flag},
            {"FIRSTHIT_VERTEX_COLORS", flag}, {"FIRSTHIT_TANGENTS", flag},
            {"FIRSTHIT_ENVIRONMENT", flag}, {"FIRSTHIT_FEW_LIGHTS", on ? "28" : "0"},
            {"FIRSTHIT_PLANE", std::to_string(plane)},
            {"FIRSTHIT_ONLY_MODEL", std::to_string(model)}};
        variants.push_back({shader, defines});
        defines.push_back({"FIRSTHIT_STORED_HITS", ""});
        defines.push_back({"FIRSTHIT_COUNT_INVOCATIONS", ""});
        variants.push_back({shader, defines});
    };
    for (const char* shader :
        {"early_z.frag", "intersect.frag", "hit_bounds.comp", "shade_hits.frag"}) {
        for (int test = 0; test < 4; ++test) add(shader, test, 1, true, 0);
        for (int model = 0; model < kModelCount; ++model) add(shader, 0, 1, true, 0, model);
        for (const int channels : {3, 4}) add(shader, 1, channels, false, 0);
    }
    for (int aov = 0; aov < kAovCount; ++aov) add("plane.frag", 1, 1, aov % 2 == 0, aov);
    return variants;
}

bool is_stage(std::string_view name)
{
    return !name.ends_with(".glsl");
}

TEST(Shaders, AllHaveVariantsHere)
{
    const std::vector<Variant> variants = all_variants();
    for (const gl::ShaderText& text : gl::shader_texts()) {
        if (!is_stage(text.name)) continue;
        const auto is_this = [&](const Variant& v) { return text.name.ends_with("/" + v.shader); };
        EXPECT_TRUE(std::any_of(variants.begin(), variants.end(), is_this)) << text.name;
    }
}

TEST(Shaders, AreAcceptedByGlslangValidator)
{
    if (std::system("command -v glslangValidator > /dev/null") != 0)
        GTEST_SKIP() << "no glslangValidator (Debian package glslang-tools)";
    for (const Variant& variant : all_variants()) {
        const std::string file = testing::TempDir() + "firsthit_" + variant.shader;
        const gl::ShaderSource source = gl::shader_source(variant.shader, variant.defines);
        std::ofstream(file) << source.text;
        EXPECT_EQ(std::system(("glslangValidator '" + file + "'").c_str()), 0)
            << variant.shader << "\n"
            << source.text;
    }
}

} // namespace
} // namespace firsthit
