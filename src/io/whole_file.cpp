// whole_file.cpp - a whole file in memory.
#include "io/whole_file.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace firsthit {

std::string read_whole_file(const std::filesystem::path& path, std::uintmax_t max_bytes)
{
    const std::string name = path.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw FileError(fmt::format("{}: no such file", name));
    if (error) throw FileError(fmt::format("{}: cannot be read: {}", name, error.message()));
    // A pipe or a device could go on for ever.
    if (!std::filesystem::is_regular_file(status))
        throw FileError(fmt::format("{}: not a regular file", name));

    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) throw FileError(fmt::format("{}: cannot be read: {}", name, error.message()));
    if (bytes > max_bytes)
        throw FileError(
            fmt::format("{}: {} bytes, at most {} are accepted", name, bytes, max_bytes));

    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(fmt::format("{}: cannot be opened: {}", name, std::strerror(errno)));
    std::string text(static_cast<std::size_t>(bytes), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.gcount() != static_cast<std::streamsize>(text.size()))
        throw FileError(fmt::format("{}: ended before its {} bytes were read", name, bytes));
    return text;
}

void add_file(const std::filesystem::path& path, std::vector<std::string>& files)
{
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) files.push_back(path.string());
}

} // namespace firsthit
