// main.cpp - the program `firsthit`: parses, calls, reports.
#include "common/interrupt.h"
#include "common/output.h"
#include "common/terminal.h"
#include "common/usage.h"
#include "help/program.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

namespace firsthit::cli {

namespace {

int fail(int exit_code, const std::string& message)
{
    std::fprintf(stderr, "%s %s\n", in_error_color("firsthit:").c_str(), message.c_str());
    return exit_code;
}

int run(int argc, char** argv)
{
    try {
        return Program().run(argc, argv);
    } catch (const UsageError& error) {
        return fail(kExitUsage, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kExitFailed, "out of memory");
    } catch (const ReaderGone&) {
        throw;
    } catch (const std::exception& error) {
        return fail(kExitFailed, error.what());
    }
}

} // namespace

} // namespace firsthit::cli

int main(int argc, char** argv)
{
    using namespace firsthit::cli;
    survive_failing_writes();
    try {
        return run(argc, argv);
    } catch (const ReaderGone&) {
        end_by_closed_pipe(); // after all that was begun has been taken back
    }
}
