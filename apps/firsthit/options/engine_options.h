// engine_options.h - which engine makes a picture, and how.
#pragma once

#include <firsthit/render.h>

#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct EngineOptions {
    Engine engine = Engine::cpu;
    int interleave = 1;
    Multisample multisample = Multisample::lazy3;
    bool no_interpolate = false;
    OpenGlSettings opengl;
};

/// "cpu", "hybrid", "gpu" or "auto". throws  UsageError
Engine parse_engine(const std::string& text);

/// What parse_engine takes.
std::string engine_name(Engine engine);

/// --interleave, --multisample, --no-interpolate, --item-format, --depth-format, --readback,
/// --readback-chunks, --gpu-passes. The engine itself is up to the command.
void add_engine_options(CLI::App& app, EngineOptions& options);

/// Fills in the settings.
void apply(const EngineOptions& options, Settings& settings);

} // namespace firsthit::cli
