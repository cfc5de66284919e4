// engine_options.cpp - which engine makes a picture, and how.
#include "options/engine_options.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <utility>

namespace firsthit::cli {

namespace {

/// Words and what they stand for.
template <class T, std::size_t N>
using Words = std::array<std::pair<const char*, T>, N>;

template <class T, std::size_t N>
T one_of(const Words<T, N>& words, const std::string& text, const char* what)
{
    std::string accepted;
    for (const auto& [word, value] : words) {
        if (text == word) return value;
        accepted += accepted.empty() ? "" : word == words.back().first ? " and " : ", ";
        accepted += word;
    }
    throw UsageError(fmt::format("'{}' is no {}: accepted are {}", text, what, accepted));
}

constexpr Words<Engine, 4> kEngines = {{{"cpu", Engine::cpu}, {"hybrid", Engine::hybrid},
    {"gpu", Engine::gpu}, {"auto", Engine::automatic}}};

ItemFormat parse_item_format(const std::string& text)
{
    constexpr Words<ItemFormat, 3> kWords = {
        {{"r32ui", ItemFormat::r32ui}, {"rgb8", ItemFormat::rgb8}, {"rgba8", ItemFormat::rgba8}}};
    return one_of(kWords, text, "item format");
}

DepthFormat parse_depth_format(const std::string& text)
{
    constexpr Words<DepthFormat, 2> kWords = {
        {{"float32", DepthFormat::float32}, {"fixed24", DepthFormat::fixed24}}};
    return one_of(kWords, text, "depth format");
}

Readback parse_readback(const std::string& text)
{
    constexpr Words<Readback, 2> kWords = {{{"sync", Readback::sync}, {"async", Readback::async}}};
    return one_of(kWords, text, "way of reading back");
}

GpuPasses parse_gpu_passes(const std::string& text)
{
    constexpr Words<GpuPasses, 2> kWords = {
        {{"single", GpuPasses::single}, {"multi", GpuPasses::multi}}};
    return one_of(kWords, text, "number of passes");
}

int parse_interleave(const std::string& text)
{
    for (const int every : {1, 2, 4, 8, 16})
        if (text == std::to_string(every)) return every;
    throw UsageError(fmt::format("'{}' is not accepted: 1, 2, 4, 8 or 16", text));
}

} // namespace

Engine parse_engine(const std::string& text)
{
    return one_of(kEngines, text, "engine");
}

std::string engine_name(Engine engine)
{
    for (const auto& [word, value] : kEngines)
        if (value == engine) return word;
    return {};
}

void add_engine_options(CLI::App& app, EngineOptions& options)
{
    const auto integer = [](int low, int high) {
        return [low, high](const std::string& text) { return parse_integer(text, low, high); };
    };
    add_parsed(app, "--interleave", options.interleave, parse_interleave, "1|2|4|8|16",
        "Shoot the ray of one pixel in N, and interpolate the pixels between; default 1: all");
    add_parsed(app, "--multisample", options.multisample, parse_multisample,
        "none|lazy3|lazy5|full3|full5|exact",
        "Engines hybrid and gpu: where OpenGL's item is missed, try the triangles of 3x3 or 5x5 "
        "pixels (lazy), try them everywhere (full), or make items exact; default lazy3");
    app.add_flag("--no-interpolate", options.no_interpolate,
        "Leave the background where a pixel's triangle is not found, or not looked for");
    add_parsed(app, "--item-format", options.opengl.item_format, parse_item_format,
        "r32ui|rgb8|rgba8",
        "How OpenGL writes items: integers, or colours of at most 2^24 - 1 or 2^32 - 1 triangles; "
        "default r32ui");
    add_parsed(app, "--depth-format", options.opengl.depth_format, parse_depth_format,
        "float32|fixed24",
        "OpenGL's depth buffer: float, reversed; or 24 bits between planes fitted to the scene; "
        "default float32");
    add_parsed(app, "--readback", options.opengl.readback, parse_readback, "sync|async",
        "Engine hybrid: items come to host memory at once, or in chunks while rays are shot; "
        "default async");
    add_parsed(app, "--readback-chunks", options.opengl.readback_chunks, integer(1, 64), "N",
        "Chunks of an asynchronous readback, 1 to 64; default 8");
    add_parsed(app, "--gpu-passes", options.opengl.passes, parse_gpu_passes, "single|multi",
        "Engine gpu: one pass shades all pixels, or pixels without an item are masked first and "
        "hits are found before they are shaded; default single");
}

void apply(const EngineOptions& options, Settings& settings)
{
    settings.engine = options.engine;
    settings.interleave = options.interleave;
    settings.multisample = options.multisample;
    settings.interpolate = !options.no_interpolate;
    settings.opengl = options.opengl;
}

} // namespace firsthit::cli
