// main.cpp - the program `firsthit`: parses, calls, reports.
#include "bench/bench_command.h"
#include "compare_command.h"
#include "info_command.h"
#include "common/interrupt.h"
#include "occlusion_command.h"
#include "common/output.h"
#include "render_command.h"
#include "common/usage.h"

#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

namespace firsthit::cli {

namespace {

constexpr const char* kFooter = R"(Examples:
  firsthit render builtin:torus -o torus.png
  firsthit info bunny.stl
  firsthit compare builtin:torus --against brute --shadows exact
  firsthit occlusion bunny.stl --points points.npy --direction -1,-2,0.5 -o shade.npy
  firsthit bench --paper -o report/

`firsthit COMMAND --help` tells more. Exit codes: 0 done, 1 failed, 2 wrong usage.)";

int fail(int exit_code, const std::string& message)
{
    std::fprintf(stderr, "firsthit: %s\n", message.c_str());
    return exit_code;
}

int run(int argc, char** argv)
{
    CLI::App app("Ray-traced pictures of moving triangle scenes with shadows, exact to the pixel.",
        "firsthit");
    app.set_version_flag("--version", "firsthit " + version());
    app.require_subcommand(1);
    app.footer(kFooter);

    RenderOptions render;
    InfoOptions info;
    CompareOptions compare;
    OcclusionOptions occlusion;
    bench::BenchOptions bench;
    CLI::App* render_command = app.add_subcommand("render", "Make pictures and planes of a scene");
    CLI::App* info_command = app.add_subcommand("info", "Tell what is in a scene");
    CLI::App* compare_command = app.add_subcommand(
        "compare", "Hold visible triangles and shadows against another ray caster's");
    CLI::App* occlusion_command =
        app.add_subcommand("occlusion", "Find out which of given points the lights do not reach");
    CLI::App* bench_command = app.add_subcommand(
        "bench", "Measure frames, beside a paper's numbers and other ray casters");
    add_render_options(*render_command, render);
    add_info_options(*info_command, info);
    add_compare_options(*compare_command, compare);
    add_occlusion_options(*occlusion_command, occlusion);
    add_bench_options(*bench_command, bench);

    try {
        app.parse(argc, argv);
        if (*render_command) return run_render(render);
        if (*info_command) return run_info(info);
        if (*occlusion_command) return run_occlusion(occlusion);
        if (*bench_command) return run_bench(bench);
        return run_compare(compare);
    } catch (const CLI::CallForHelp&) {
        print(app.help());
    } catch (const CLI::CallForVersion&) {
        print(app.version() + "\n");
    } catch (const CLI::ParseError& error) {
        const auto commands = app.get_subcommands();
        const std::string command = commands.empty() ? "" : commands[0]->get_name() + " ";
        return fail(
            kExitUsage, fmt::format("{}\nRun firsthit {}--help for more.", error.what(), command));
    }
    return kExitDone;
}

} // namespace

} // namespace firsthit::cli

int main(int argc, char** argv)
{
    using namespace firsthit::cli;
    survive_file_size_limit();
    try {
        return run(argc, argv);
    } catch (const UsageError& error) {
        return fail(kExitUsage, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kExitFailed, "out of memory");
    } catch (const std::exception& error) {
        return fail(kExitFailed, error.what());
    }
}
