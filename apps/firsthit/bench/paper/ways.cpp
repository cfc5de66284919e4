// ways.cpp - the kinds of frames that the paper's section 5 compares.
#include "bench/paper/ways.h"

#include <firsthit/error.h>

namespace firsthit::cli::bench {

std::vector<Way> paper_ways()
{
    std::vector<Way> ways;
    const auto add = [&](const char* name, Engine engine) -> Settings& {
        ways.push_back({.name = name, .settings = {}});
        Settings& settings = ways.back().settings;
        settings.engine = engine;
        settings.multisample = Multisample::none;
        settings.shadows = Shadows::none;
        return settings;
    };
    add("hybrid sync", Engine::hybrid).opengl.readback = Readback::sync;
    add("hybrid", Engine::hybrid);
    add("hybrid maps", Engine::hybrid).shadows = Shadows::map;
    add("hybrid interleaved", Engine::hybrid).interleave = kPaperInterleave;
    add("hybrid lazy3", Engine::hybrid).multisample = Multisample::lazy3;
    add("hybrid lazy5", Engine::hybrid).multisample = Multisample::lazy5;
    add("hybrid full3", Engine::hybrid).multisample = Multisample::full3;
    add("hybrid full5", Engine::hybrid).multisample = Multisample::full5;
    add("gpu", Engine::gpu);
    add("gpu maps", Engine::gpu).shadows = Shadows::map;
    add("cpu", Engine::cpu);
    add("cpu interleaved", Engine::cpu).interleave = kPaperInterleave;
    add("cpu maps", Engine::cpu).shadows = Shadows::map;
    add("cpu exact", Engine::cpu).shadows = Shadows::exact;
    return ways;
}

Way paper_way(const std::string& name)
{
    for (const Way& way : paper_ways())
        if (way.name == name) return way;
    throw ArgumentError("the paper has no frames of the kind '" + name + "'");
}

} // namespace firsthit::cli::bench
