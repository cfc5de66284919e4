// switch_table.cpp - the table of all switches of the viewer.
#include "common/parse.h"
#include "view/session/switches.h"

#include <fmt/format.h>

#include <utility>

namespace firsthit::cli::view {
namespace {

template <class T>
using Words = std::vector<std::pair<const char*, T>>;

/// A switch of a part of the state that one of some words says.
template <class T, class Part>
Switch word_switch(
    const char* group, const char* name, const char* text, const Words<T>& words, Part part)
{
    Switch made{.name = name, .group = group, .text = text};
    for (const auto& [word, value] : words) made.words.emplace_back(word);
    made.get = [words, part](const ViewState& state) {
        for (const auto& [word, value] : words)
            if (part(const_cast<ViewState&>(state)) == value) return std::string(word);
        return std::string();
    };
    made.set = [words, part](ViewState& state, const std::string& chosen) {
        for (const auto& [word, value] : words)
            if (chosen == word) part(state) = value;
    };
    return made;
}

template <class Part>
Switch on_off(const char* group, const char* name, const char* text, Part part)
{
    return word_switch<bool>(group, name, text, {{"off", false}, {"on", true}}, part);
}

template <class Part>
Switch number(const char* group, const char* name, const char* text, double least, double most,
    bool whole, Part part)
{
    Switch made{.name = name, .group = group, .text = text, .least = least, .most = most};
    made.whole = whole;
    made.get = [part](const ViewState& state) {
        return fmt::format("{}", double(part(const_cast<ViewState&>(state))));
    };
    made.set = [part](ViewState& state, const std::string& chosen) {
        auto& value = part(state);
        value = static_cast<std::remove_reference_t<decltype(value)>>(parse_number(chosen));
    };
    return made;
}

void add_looks(std::vector<Switch>& all)
{
    const char* group = "look";
    all.push_back(word_switch<Look>(group, "look", "what is shown",
        {{"color", Look::color}, {"items", Look::items}, {"instances", Look::instances},
            {"materials", Look::materials}, {"depth", Look::depth}, {"normals", Look::normals},
            {"uv", Look::uv}, {"light", Look::light}, {"light-view", Look::light_view},
            {"difference", Look::difference}, {"wrong", Look::wrong}},
        [](ViewState& s) -> Look& { return s.look; }));
    all.push_back(number(group, "light", "which light, for looks light and light-view", 0, 63, true,
        [](ViewState& s) -> int& { return s.light; }));
    all.push_back(number(group, "exposure", "light times 2 to this", -20, 20, false,
        [](ViewState& s) -> double& { return s.tone.exposure_ev; }));
    all.push_back(word_switch<ToneMap>(group, "tonemap", "how light above 1 is shown",
        {{"none", ToneMap::none}, {"aces", ToneMap::aces},
            {"khronos-pbr-neutral", ToneMap::khronos_pbr_neutral}},
        [](ViewState& s) -> ToneMap& { return s.tone.map; }));
    all.push_back(on_off(group, "dither", "dither the exact picture",
        [](ViewState& s) -> bool& { return s.dither; }));
}

void add_animation(std::vector<Switch>& all)
{
    const char* group = "animation";
    all.push_back(
        on_off(group, "play", "the clip runs", [](ViewState& s) -> bool& { return s.playing; }));
    all.push_back(on_off(group, "loop", "the clip begins again at its end",
        [](ViewState& s) -> bool& { return s.loop; }));
    all.push_back(number(group, "speed", "seconds of the clip in a second", -100, 100, false,
        [](ViewState& s) -> double& { return s.speed; }));
    all.push_back(number(group, "time", "seconds of the clip", -1e6, 1e6, false,
        [](ViewState& s) -> double& { return s.time_s; }));
    all.push_back(number(group, "clip", "the animation; -1: at rest", -1, 1e6, true,
        [](ViewState& s) -> std::int32_t& { return s.clip; }));
    all.push_back(on_off(group, "turntable", "the camera goes round the scene",
        [](ViewState& s) -> bool& { return s.turntable; }));
    all.push_back(number(group, "camera", "of the file", 0, 1e6, true,
        [](ViewState& s) -> int& { return s.camera; }));
    all.push_back(number(group, "selected", "an instance; -1: none", -1, 2e9, true,
        [](ViewState& s) -> std::int32_t& { return s.selected; }));
}

void add_frame(std::vector<Switch>& all)
{
    const char* group = "frame";
    all.push_back(word_switch<Engine>(group, "engine", "who makes the picture",
        {{"cpu", Engine::cpu}, {"hybrid", Engine::hybrid}, {"gpu", Engine::gpu},
            {"auto", Engine::automatic}},
        [](ViewState& s) -> Engine& { return s.settings.engine; }));
    all.push_back(number(group, "samples", "N x N rays in each pixel", 1, 16, true,
        [](ViewState& s) -> int& { return s.settings.samples; }));
    all.push_back(number(group, "aa", "N x N rays at edges", 1, 16, true,
        [](ViewState& s) -> int& { return s.settings.adaptive; }));
    all.push_back(word_switch<int>(group, "interleave", "shoot the ray of one pixel in N",
        {{"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}},
        [](ViewState& s) -> int& { return s.settings.interleave; }));
    all.push_back(on_off(group, "interpolate", "fill pixels whose triangle is not found",
        [](ViewState& s) -> bool& { return s.settings.interpolate; }));
    all.push_back(number(group, "tile-size", "pixels on a tile's side, by eights", 8, 128, true,
        [](ViewState& s) -> int& { return s.settings.tile_size; }));
    all.back().set = [](ViewState& s, const std::string& chosen) {
        s.settings.tile_size = (static_cast<int>(parse_number(chosen)) + 4) / 8 * 8;
    };
    all.push_back(on_off(group, "hold", "while something moves, leave out what is dear",
        [](ViewState& s) -> bool& { return s.hold_rate; }));
    all.push_back(number(group, "rate", "frames a second to hold", 1, 240, false,
        [](ViewState& s) -> double& { return s.rate; }));
}

void add_light(std::vector<Switch>& all)
{
    const char* group = "shadows and sky";
    all.push_back(word_switch<Shadows>(group, "shadows", "how they are found",
        {{"auto", Shadows::automatic}, {"none", Shadows::none}, {"map", Shadows::map},
            {"exact", Shadows::exact}},
        [](ViewState& s) -> Shadows& { return s.settings.shadows; }));
    all.push_back(number(group, "shadow-map-size", "texels of maps; 0: chosen", 0, 8192, true,
        [](ViewState& s) -> int& { return s.settings.shadow_map_size; }));
    all.back().set = [](ViewState& s, const std::string& chosen) {
        const int size = static_cast<int>(parse_number(chosen));
        s.settings.shadow_map_size = size == 0 ? 0 : std::max(16, size);
    };
    all.push_back(number(group, "shadow-bias", "of maps, world units; below 0: by slope", -1, 1e6,
        false, [](ViewState& s) -> double& { return s.settings.shadow_bias; }));
    all.push_back(number(group, "shadow-filter", "N x N texels of maps", 1, 15, true,
        [](ViewState& s) -> int& { return s.settings.shadow_filter; }));
    all.push_back(number(group, "sky", "directions of the sky; 0: none", 0, Sky::kMostDirections,
        true, [](ViewState& s) -> int& { return s.settings.sky.directions; }));
    all.push_back(on_off(group, "studio", "light and background of the studio",
        [](ViewState& s) -> bool& { return s.studio; }));
    all.push_back(word_switch<EnvironmentChoice>(group, "environment", "light from all around",
        {{"given", EnvironmentChoice::given}, {"none", EnvironmentChoice::none},
            {"studio", EnvironmentChoice::studio}},
        [](ViewState& s) -> EnvironmentChoice& { return s.environment; }));
}

void add_opengl(std::vector<Switch>& all)
{
    const char* group = "OpenGL";
    all.push_back(word_switch<ItemFormat>(group, "item-format", "how OpenGL writes items",
        {{"r32ui", ItemFormat::r32ui}, {"rgb8", ItemFormat::rgb8}, {"rgba8", ItemFormat::rgba8}},
        [](ViewState& s) -> ItemFormat& { return s.settings.opengl.item_format; }));
    all.push_back(word_switch<DepthFormat>(group, "depth-format", "of OpenGL's depth buffer",
        {{"float32", DepthFormat::float32}, {"fixed24", DepthFormat::fixed24}},
        [](ViewState& s) -> DepthFormat& { return s.settings.opengl.depth_format; }));
    all.push_back(word_switch<Readback>(group, "readback", "hybrid: items at once or in chunks",
        {{"sync", Readback::sync}, {"async", Readback::async}},
        [](ViewState& s) -> Readback& { return s.settings.opengl.readback; }));
    all.push_back(number(group, "readback-chunks", "how many", 1, 64, true,
        [](ViewState& s) -> int& { return s.settings.opengl.readback_chunks; }));
    all.push_back(word_switch<GpuPasses>(group, "gpu-passes", "gpu: one pass or several",
        {{"single", GpuPasses::single}, {"multi", GpuPasses::multi}},
        [](ViewState& s) -> GpuPasses& { return s.settings.opengl.passes; }));
    all.push_back(word_switch<Multisample>(group, "multisample", "repair of OpenGL's items",
        {{"none", Multisample::none}, {"lazy3", Multisample::lazy3}, {"lazy5", Multisample::lazy5},
            {"full3", Multisample::full3}, {"full5", Multisample::full5},
            {"exact", Multisample::exact}},
        [](ViewState& s) -> Multisample& { return s.settings.multisample; }));
}

void add_window(std::vector<Switch>& all)
{
    const char* group = "window";
    all.push_back(
        on_off(group, "panel", "these switches", [](ViewState& s) -> bool& { return s.panel; }));
    all.push_back(
        on_off(group, "bars", "times of stages", [](ViewState& s) -> bool& { return s.bars; }));
    all.push_back(on_off(
        group, "corner", "what is on screen", [](ViewState& s) -> bool& { return s.corner; }));
    all.push_back(on_off(group, "hover", "what is under the pointer",
        [](ViewState& s) -> bool& { return s.hover; }));
    all.push_back(
        on_off(group, "help", "the page of keys", [](ViewState& s) -> bool& { return s.help; }));
}

std::vector<Switch> make_switches()
{
    std::vector<Switch> all;
    add_looks(all);
    add_animation(all);
    add_frame(all);
    add_light(all);
    add_opengl(all);
    add_window(all);
    return all;
}

} // namespace

std::span<const Switch> all_switches()
{
    static const std::vector<Switch> kAll = make_switches();
    return kAll;
}

} // namespace firsthit::cli::view
