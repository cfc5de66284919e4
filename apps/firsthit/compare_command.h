// compare_command.h - `firsthit compare`: holds items and shadows against another ray caster, or an
// engine on OpenGL against the cpu engine.
#pragma once

#include "common/json.h"
#include "options/engine_options.h"
#include "options/light_options.h"
#include "options/picture_set_options.h"

#include <firsthit/compare.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct CompareOptions : PictureSetOptions {
    std::optional<Oracle> oracle; // none: the cpu engine
    EngineOptions engine;
    LightOptions light;                   // of which --light is an option
    Shadows shadows = Shadows::automatic; // of pictures; exact: lights are compared with oracles
    bool json = false;
};

void add_compare_options(CLI::App& app, CompareOptions& options);

/// throws  UsageError: an engine or shadows that cannot be compared with what was asked for
void check(const CompareOptions& options);

Comparison operator+(const Comparison& a, const Comparison& b);

LitComparison operator+(const LitComparison& a, const LitComparison& b);

/// lit  nothing where shadows were not compared
Json comparison_json(const Comparison& comparison, const std::optional<LitComparison>& lit);
std::string comparison_text(const Comparison& comparison, const std::optional<LitComparison>& lit);

/// returns  an exit code: 0 only where ours is wrong nowhere; of engines that are not exact always 0
int run_compare(const CompareOptions& options);

} // namespace firsthit::cli
