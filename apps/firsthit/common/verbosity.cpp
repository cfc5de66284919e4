// verbosity.cpp - how much the program says beside its results: --quiet, --verbose.
#include "common/verbosity.h"

#include <cstdio>

namespace firsthit::cli {
namespace {

// One process says everything in one way.
Verbosity g_verbosity = Verbosity::usual;

} // namespace

Verbosity verbosity()
{
    return g_verbosity;
}

void set_verbosity(Verbosity verbosity)
{
    g_verbosity = verbosity;
}

void print_detail(const std::string& text)
{
    if (g_verbosity == Verbosity::verbose) std::fprintf(stderr, "firsthit: %s\n", text.c_str());
}

} // namespace firsthit::cli
