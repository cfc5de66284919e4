// world_statements.cpp - camera, lights, surroundings and materials of an AFF scene.
#include "readers/aff/statements.h"

#include "io/parse_number.h"

#include <glm/trigonometric.hpp>

#include <cctype>
#include <cmath>
#include <string_view>

namespace firsthit::aff {
namespace {

constexpr int kMostPixels = 65536; // of a picture's side

/// A light's colour, white where it has none.
glm::vec3 optional_color(Lexer& lexer)
{
    const std::optional<float> red = lexer.small_number_if_next("the light's red");
    if (!red) return glm::vec3(1);
    const float green = lexer.small_number("the light's green");
    const float blue = lexer.small_number("the light's blue");
    return {*red, green, blue};
}

void set_material(const Lexer& lexer, State& state, const Phong& material)
{
    state.material_name = lexer.file() + ":" + std::to_string(lexer.line());
    state.material = material;
}

/// Some programs write more numbers behind a material, or the file of a texture, which shapes of NFF have no
/// coordinates for. Other statements may follow on the line.
void leave_out_extensions(Lexer& lexer, State& state)
{
    while (lexer.has_more_on_line()) {
        const bool is_number = parse_number(lexer.peek()).has_value();
        if (!is_number && lexer.peek().find('.') == std::string_view::npos) return;
        lexer.next();
        state.builder.problems.add(is_number ? "spare numbers of materials are left out"
                                             : "textures of materials are left out",
            "line", lexer.line());
    }
}

/// A number of a material, of which programs leave the last ones out before the next statement.
float number_or(float missing, Lexer& lexer, State& state, const char* what)
{
    const std::string_view word = lexer.peek();
    const bool is_statement =
        !word.empty() && std::isalpha(static_cast<unsigned char>(word[0])) && !says_no_number(word);
    if (!is_statement) return lexer.small_number(what);
    state.builder.problems.add(
        "missing numbers of materials are those of a matt one", "line", lexer.line());
    return missing;
}

} // namespace

void read_view(Lexer& lexer, State& state)
{
    state.camera_place = lexer.place();
    Camera camera;
    lexer.expect("from", "v");
    camera.eye = lexer.small_triple("the camera's place");
    lexer.expect("at", "v");
    camera.direction = glm::dvec3(lexer.small_triple("the camera's target")) - camera.eye;
    lexer.expect("up", "v");
    camera.up = lexer.small_triple("the camera's up");
    lexer.expect("angle", "v");
    const double angle_deg = lexer.number("the camera's angle");
    if (!(angle_deg > 0 && angle_deg < 180))
        lexer.fail_scene("the camera's angle should lie between 0 and 180 degrees, not be " +
                         std::to_string(angle_deg));
    camera.fov_y_rad = glm::radians(angle_deg);
    lexer.expect("hither", "v");
    lexer.number("the camera's near plane");
    lexer.expect("resolution", "v");
    const double width = lexer.number("the picture's width");
    const double height = lexer.number("the picture's height");
    const auto fits = [](double side) {
        return 1 <= side && side <= kMostPixels && side == std::floor(side);
    };
    if (fits(width) && fits(height))
        state.builder.scene.set_picture_size({int(width), int(height)});
    else
        state.builder.problems.add(
            "a resolution other than whole numbers of 1 to 65536 is left out", "line",
            lexer.line());
    state.builder.camera = camera;
}

void read_light(Lexer& lexer, State& state)
{
    Light light;
    light.position = lexer.small_triple("the light's place");
    light.color = optional_color(lexer);
    state.builder.add_light(light, {});
}

void read_moving_light(Lexer& lexer, State& state)
{
    const std::string_view track = lexer.word("the light's name");
    Light light;
    light.position = lexer.small_triple("the light's place");
    light.color = optional_color(lexer);
    state.builder.add_light(light, track);
}

void read_background(Lexer& lexer, State& state)
{
    state.builder.scene.set_background(lexer.small_triple("the background's colour"));
}

void read_ambient(Lexer& lexer, State& state)
{
    state.builder.scene.set_ambient(lexer.small_triple("the ambient light's colour"));
}

void read_animation(Lexer& lexer, State& state)
{
    Clip& clip = state.builder.clip;
    clip.begin_s = lexer.small_number("the animation's start");
    clip.end_s = lexer.small_number("the animation's end");
    const std::int64_t frames = lexer.integer("the number of frames");
    if (clip.end_s < clip.begin_s) lexer.fail_scene("the animation ends before it starts");
    if (frames < 1 || frames > 1'000'000'000)
        lexer.fail_scene("the number of frames should lie between 1 and 1000000000, not be " +
                         std::to_string(frames));
    clip.frames = static_cast<int>(frames);
}

void read_detail(Lexer& lexer, State& state)
{
    state.detail = lexer.integer("the detail level");
}

void read_simple_material(Lexer& lexer, State& state)
{
    Phong material;
    const glm::vec3 color = lexer.small_triple("the material's colour");
    const float diffuse = number_or(1, lexer, state, "the material's Kd");
    material.ambient = glm::vec3(0);
    material.diffuse = diffuse * color;
    material.specular = glm::vec3(number_or(0, lexer, state, "the material's Ks"));
    material.shininess = number_or(1, lexer, state, "the material's shine");
    material.transmittance = number_or(0, lexer, state, "the material's T");
    material.ior = number_or(1, lexer, state, "the material's index of refraction");
    for (int channel = 0; channel < 3; ++channel)
        if (!std::isfinite(material.diffuse[channel]))
            lexer.fail_scene("the material's Kd times its colour is too large");
    set_material(lexer, state, material);
    leave_out_extensions(lexer, state);
}

void read_full_material(Lexer& lexer, State& state)
{
    Phong material;
    material.ambient = lexer.small_triple("the material's ambient colour");
    material.diffuse = lexer.small_triple("the material's diffuse colour");
    material.specular = lexer.small_triple("the material's specular colour");
    material.shininess = lexer.small_number("the material's shine");
    material.transmittance = lexer.small_number("the material's T");
    material.ior = lexer.small_number("the material's index of refraction");
    set_material(lexer, state, material);
}

} // namespace firsthit::aff
