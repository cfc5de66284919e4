// program.cpp - the commands of the program, their options, and their help.
#include "help/program.h"

#include "bench/bench_command.h"
#include "cast_command.h"
#include "common/output.h"
#include "common/terminal.h"
#include "common/usage.h"
#include "common/verbosity.h"
#include "compare_command.h"
#include "help/completion.h"
#include "help/help_page.h"
#include "help/man_page.h"
#include "help/suggest.h"
#include "info_command.h"
#include "join_command.h"
#include "mask_command.h"
#include "occlusion_command.h"
#include "render_command.h"
#include "view/view_command.h"
#include "visible_command.h"

#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace firsthit::cli {

struct Program::Impl {
    CLI::App app{"Ray-traced pictures of moving triangle scenes with shadows, exact to the pixel.",
        "firsthit"};
    RenderOptions render;
    InfoOptions info;
    JoinOptions join;
    MaskOptions mask;
    VisibleOptions visible;
    CompareOptions compare;
    OcclusionOptions occlusion;
    CastOptions cast;
    ViewOptions view;
    bench::BenchOptions bench;
    std::string topic, shell; // of help and completion
    bool quiet = false, verbose = false;
    std::map<const CLI::App*, std::function<int()>> action;

    template <class Add, class Run>
    CLI::App* add(const char* name, const char* description, const Add& add_options, const Run& run)
    {
        CLI::App* command = app.add_subcommand(name, description);
        add_options(*command);
        action[command] = run;
        return command;
    }

    void add_manners(CLI::App& command)
    {
        CLI::Option* said = command.add_flag(
            "-q,--quiet", quiet, "No warnings and no bar of progress: errors alone");
        command.add_flag("-v,--verbose", verbose, "Say what is done, on standard error")
            ->excludes(said);
    }

    const CLI::App* command_called(const std::string& name) const
    {
        const CLI::App* command = find_command(app, name);
        if (command && !command->get_group().empty()) return command;
        const std::string nearest = nearest_word(name, command_names(app));
        throw UsageError(fmt::format("there is no command '{}'{}\nRun firsthit --help for all.",
            name, nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }

    int show(const std::string& text)
    {
        print(text);
        return kExitDone;
    }

    void add_working_commands();
    void add_helping_commands();
    void check_command(int argc, const char* const* argv);
    [[noreturn]] void fail(const CLI::ParseError& error, int argc, const char* const* argv) const;
};

void Program::Impl::add_working_commands()
{
    add(
        "render", "Make pictures, films and planes of a scene",
        [&](CLI::App& command) { add_render_options(command, render); },
        [&] { return run_render(render); });
    add(
        "view", "Look at a scene in a window, and at how its picture is made",
        [&](CLI::App& command) { add_view_options(command, view); },
        [&] { return run_view(view); });
    add(
        "info", "Tell what is in a scene",
        [&](CLI::App& command) { add_info_options(command, info); },
        [&] { return run_info(info); });
    add(
        "join", "Put pictures of regions together",
        [&](CLI::App& command) { add_join_options(command, join); },
        [&] { return run_join(join); });
    add(
        "mask", "Write masks of what is seen, in the layout of COCO",
        [&](CLI::App& command) { add_mask_options(command, mask); },
        [&] { return run_mask(mask); });
    add(
        "visible", "List the triangles that are seen, with their pixels",
        [&](CLI::App& command) { add_visible_options(command, visible); },
        [&] { return run_visible(visible); });
    add(
        "compare", "Hold visible triangles and shadows against another ray caster's",
        [&](CLI::App& command) { add_compare_options(command, compare); },
        [&] { return run_compare(compare); });
    add(
        "occlusion", "Find out which of given points the lights do not reach",
        [&](CLI::App& command) { add_occlusion_options(command, occlusion); },
        [&] { return run_occlusion(occlusion); });
    add(
        "cast", "Find out what any rays hit",
        [&](CLI::App& command) { add_cast_options(command, cast); },
        [&] { return run_cast(cast); });
    add(
        "bench", "Measure frames, beside a paper's numbers and other ray casters",
        [&](CLI::App& command) { add_bench_options(command, bench); },
        [&] { return run_bench(bench); });
    for (const auto& [command, run] : action)
        add_manners(const_cast<CLI::App&>(*command)); // which are the app's own
}

void Program::Impl::add_helping_commands()
{
    add(
        "help", "Tell more about a command",
        [&](CLI::App& command) { command.add_option("COMMAND", topic, "The command"); },
        [&] {
            const auto columns = std::size_t(text_columns());
            return show(topic.empty() ? program_help(app, columns)
                                      : short_help(*command_called(topic), columns));
        });
    // For the build, which installs what they print.
    add(
        "completion", "Print the script that completes command lines",
        [&](CLI::App& command) {
            command.add_option("SHELL", shell, "bash, zsh or fish")->required();
        },
        [&] { return show(completion_script(app, shell)); })
        ->group("");
    add(
        "man", "Print the manual", [](CLI::App&) {}, [&] { return show(man_page(app)); })
        ->group("");
}

/// A first word that is no command is told before anything else.
void Program::Impl::check_command(int argc, const char* const* argv)
{
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        if (!word.empty() && word[0] == '-') continue;
        if (!find_command(app, word)) (void)command_called(word);
        return;
    }
}

void Program::Impl::fail(const CLI::ParseError& error, int argc, const char* const* argv) const
{
    const auto commands = app.get_subcommands();
    const CLI::App& command = commands.empty() ? app : *commands[0];
    const std::string name = commands.empty() ? "" : command.get_name() + " ";
    std::string hint;
    if (dynamic_cast<const CLI::ExtrasError*>(&error))
        hint = option_suggestion(command, std::vector<std::string>(argv + 1, argv + argc));
    throw UsageError(
        fmt::format("{}{}\nRun firsthit {}--help for more.", error.what(), hint, name));
}

Program::Program() : impl_(std::make_unique<Impl>())
{
    CLI::App& app = impl_->app;
    app.set_help_flag("-h,--help", "Print what most people need");
    app.set_help_all_flag("--help-all", "Print all options");
    impl_->add_working_commands();
    impl_->add_helping_commands();
    impl_->add_manners(app); // also before the command
    app.set_version_flag("-V,--version", "firsthit " + version());
    app.require_subcommand(1);
}

Program::~Program() = default;

const CLI::App& Program::app() const
{
    return impl_->app;
}

int Program::run(int argc, const char* const* argv)
{
    CLI::App& app = impl_->app;
    const auto page = [&](const auto& of_command) {
        const auto columns = std::size_t(text_columns());
        const auto commands = app.get_subcommands();
        return impl_->show(
            commands.empty() ? program_help(app, columns) : of_command(*commands[0], columns));
    };
    impl_->check_command(argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return page(short_help);
    } catch (const CLI::CallForAllHelp&) {
        return page(full_help);
    } catch (const CLI::CallForVersion&) {
        return impl_->show(app.version() + "\n");
    } catch (const CLI::ParseError& error) {
        impl_->fail(error, argc, argv);
    }
    if (impl_->quiet) set_verbosity(Verbosity::quiet);
    if (impl_->verbose) set_verbosity(Verbosity::verbose);
    return impl_->action.at(app.get_subcommands()[0])();
}

} // namespace firsthit::cli
