// glsl_test.cpp - the maths text is GLSL 4.50 too, says glslangValidator where there is one.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace firsthit {
namespace {

std::string text_of(const std::string& file)
{
    std::ifstream in(std::string(FIRSTHIT_SOURCE_DIR) + "/src/" + file);
    EXPECT_TRUE(in) << file;
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// A fragment shader that calls into the text, so that nothing is left unread.
std::string shader()
{
    return "#version 450\n"
           "#define FIRSTHIT_PURE\n#define FIRSTHIT_UNUSED\n"
           "#define real float\n#define real2 vec2\n#define real3 vec3\n"
           "#define integer int\n#define truth bool\n"
           "#define all_lanes(v) (v)\n"
           "#define shift_left_23(a) ((a) << 23)\n#define shift_right_23(a) ((a) >> 23)\n"
           "#define shift_right_15(a) ((a) >> 15)\n" +
           text_of("glsl/hit_position.glsl") + text_of("glsl/spot_cone.glsl") +
           text_of("glsl/power.glsl") + text_of("material/surface.glsl") +
           "struct Phong { vec3 ambient, diffuse, specular; float shininess; };\n" +
           text_of("material/phong.glsl") + text_of("glsl/texture.glsl") +
           text_of("glsl/shadow_map.glsl") + R"(
layout(location = 0) out vec4 color;
void main()
{
    vec3 d = ray_direction(gl_FragCoord.x, gl_FragCoord.y, 0.01, 0.02, vec3(1, 0, 0),
        vec3(0, -1, 0), vec3(0, 0, -1));
    vec3 p = hit_position(vec3(0), d, 3.0);
    Surface surface;
    surface.position = p;
    surface.to_eye = unit(-d);
    surface.normal = visible_normal(p, vec3(0, 0, 1), unit(-d));
    PhongInputs phong = inputs_of(Phong(vec3(0.1), vec3(0.5), vec3(0.5), p.x), vec3(1));
    Texels texels = bilinear_texels(repeat(p.x), 1.0 - p.y, 64.0, level_size(32.0, p.z));
    TexelWeights weights = texel_weights(texels, whole_weight());
    float level = mip_level(footprint2(p.x, p.y, 3.0, vec2(1), vec2(2), vec2(3), vec2(64)), 5.0);
    if (is_shadowed(p.y, p.z, slope_bias(p.z, 1.5, 0.01))) level = 0.0;
    vec3 lit = (emitted(phong, albedo(phong)) + reflected(phong, surface, vec3(0, 1, 0), vec3(1)))
        * cone_share(versine(vec3(0, -1, 0), p), 0.5, 3.0);
    color = vec4(lit * level, texel_light(weights.top_left * texels.top));
}
)";
}

TEST(Glsl, TextIsAcceptedByGlslangValidator)
{
    if (std::system("command -v glslangValidator > /dev/null") != 0)
        GTEST_SKIP() << "no glslangValidator (Debian package glslang-tools)";
    const std::string file = testing::TempDir() + "firsthit_text.frag";
    std::ofstream(file) << shader();
    EXPECT_EQ(std::system(("glslangValidator '" + file + "'").c_str()), 0) << shader();
}

} // namespace
} // namespace firsthit
