// glsl_test.cpp - glslangValidator, if installed, accepts the texts of src/glsl/ as GLSL 4.50.
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

/// A fragment shader that calls the functions of the texts, so that the compiler checks them all.
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
           text_of("material/phong.glsl") +
           "struct MetallicRoughness { vec3 base_color, emission; float metallic; vec3 f0; float "
           "roughness,"
           " specular, normal_scale, occlusion_strength; };\n" +
           text_of("material/metallic_roughness.glsl") + text_of("glsl/falloff.glsl") +
           R"(
struct EnvironmentTables { int unused; };
uniform vec3 terms[9];
uniform sampler2D texels;
vec3 diffuse_term(EnvironmentTables tables, int k) { return terms[k]; }
float level_side(EnvironmentTables tables, float level) { return 16.0; }
float level_first(EnvironmentTables tables, float level) { return 0.0; }
float table_first(EnvironmentTables tables) { return 0.0; }
vec3 weighted_light(EnvironmentTables tables, int top, int bottom, FourWeights weights)
{
    return texelFetch(texels, ivec2(top, bottom), 0).rgb * weights.top_left;
}
vec3 turned_back(vec3 d, float cosine, float sine);
vec3 environment_space(EnvironmentTables tables, vec3 d) { return turned_back(d, 1.0, 0.0); }
float environment_strength(EnvironmentTables tables) { return 1.0; }
)" + text_of("glsl/environment.glsl") +
           text_of("glsl/texture.glsl") + text_of("glsl/shadow_map.glsl") + R"(
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
    if (is_shadowed_by_texel(p.y, p.z, slope_bias(p.z, 1.5, 0.01))) level = 0.0;
    vec3 lit = (emitted(phong, albedo(phong)) + reflected(phong, surface, vec3(0, 1, 0), vec3(1)))
        * cone_share(versine(vec3(0, -1, 0), p), 0.5, 3.0);
    MapColors maps;
    for (int k = 0; k < kMostMaps; ++k) maps.map[k] = MapColor(p, p.x);
    MetallicRoughnessInputs rough = inputs_of(MetallicRoughness(vec3(0.1), p, p.x, p, p.y, 1.0, 2.0, 0.5), maps);
    surface.normal = mapped_normal(p, d, 1.0, p, 0.5);
    lit += (emitted(rough, albedo(rough)) + reflected(rough, surface, vec3(0, 1, 0), vec3(1)))
        * squared_cone_share(p.x, 0.5, 3.0) * inverse_square(p.x, 0.1);
    AroundLight around = around_light(EnvironmentTables(0), surface.normal, surface.to_eye, roughness(rough));
    lit += surrounded(rough, around) + environment_from(EnvironmentTables(0), d) + emission(rough) * metallic(rough);
    Texels nearest = nearest_texels(wrapped(p.x, 1), wrapped(p.y, 2), 64.0, 32.0);
    level *= moved_footprint2(vec2(1), vec2(2), vec2(3), vec2(4), vec2(64)) + float(nearest.top);
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
