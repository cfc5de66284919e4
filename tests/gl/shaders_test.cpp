// shaders_test.cpp - every shader in every variant is accepted by glslangValidator.
#include "gl/program.h"
#include "gl/shader_texts.h"

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

/// All that the library compiles: a new shader or define gets its line here.
std::vector<Variant> all_variants()
{
    std::vector<Variant> variants = {{"certify.vert", {}}, {"scatter.vert", {}},
        {"scatter.frag", {}}, {"certify.geom", {}}, {"certify.frag", {{"DOUBTS", "0"}}},
        {"certify.frag", {{"DOUBTS", "1"}}}, {"item.vert", {{"COLORS", "0"}}},
        {"item.frag", {{"COLORS", "0"}}}, {"item.frag", {{"COLORS", "1"}}},
        {"pose.comp", {{"SURFACES", "0"}}}, {"pose.comp", {{"SURFACES", "1"}}}, {"screen.vert", {}},
        {"early_z.frag", {}}, {"intersect.frag", {}},
        {"intersect.frag", {{"FIRSTHIT_COUNT_INVOCATIONS", ""}}}, {"shadow_depth.vert", {}},
        {"shadow_depth.frag", {}}, {"store_map.comp", {}}, {"average.frag", {}},
        {"fill_holes.frag", {}}};
    for (const bool stored : {false, true}) {
        gl::Defines defines;
        if (stored) defines.push_back({"FIRSTHIT_STORED_HITS", ""});
        variants.push_back({"shade_hits.frag", defines});
        variants.push_back({"hit_bounds.comp", defines});
        for (int aov = 0; aov < kAovCount; ++aov) {
            variants.push_back({"plane.frag", defines});
            variants.back().defines.push_back({"FIRSTHIT_PLANE", std::to_string(aov)});
        }
        defines.push_back({"FIRSTHIT_COUNT_INVOCATIONS", ""});
        variants.push_back({"shade_hits.frag", defines});
    }
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
