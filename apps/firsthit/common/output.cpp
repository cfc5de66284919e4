// output.cpp - text for the user: results to stdout, warnings to stderr.
#include "common/output.h"

#include "common/terminal.h"
#include "common/verbosity.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace firsthit::cli {

namespace {

void write_all(std::FILE* file, std::string_view text, const std::string& name)
{
    if (std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0)
        return;
    if (errno == EPIPE) throw ReaderGone();
    throw FileError(
        fmt::format("{}: cannot write: {}", name, std::generic_category().message(errno)));
}

} // namespace

void print(std::string_view text)
{
    write_all(stdout, text, "standard output");
}

void print_warnings(const std::vector<std::string>& warnings)
{
    if (verbosity() == Verbosity::quiet) return;
    const std::string head = in_warning_color("firsthit: warning:");
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "%s %s\n", head.c_str(), warning.c_str());
}

} // namespace firsthit::cli
