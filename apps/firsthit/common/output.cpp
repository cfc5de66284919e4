// output.cpp - text for the user: results to stdout, warnings to stderr.
#include "common/output.h"

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
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "firsthit: warning: %s\n", warning.c_str());
}

} // namespace firsthit::cli
