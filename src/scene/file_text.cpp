// file_text.cpp - reads a whole file into memory.
#include "scene/file_text.h"

#include <firsthit/error.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

namespace firsthit {
namespace {

constexpr std::uintmax_t kMaxBytes = std::uintmax_t(1) << 32;

} // namespace

std::string read_file_text(const std::filesystem::path& path)
{
    const std::string name = path.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw FileError(name + ": no such file");
    if (error) throw FileError(name + ": cannot be read: " + error.message());
    // A pipe or a device could go on for ever.
    if (!std::filesystem::is_regular_file(status)) throw FileError(name + ": not a regular file");

    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) throw FileError(name + ": cannot be read: " + error.message());
    if (bytes > kMaxBytes)
        throw FileError(name + ": " + std::to_string(bytes) + " bytes is too large, at most " +
                        std::to_string(kMaxBytes) + " are accepted");

    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(name + ": cannot be opened: " + std::strerror(errno));
    std::string text(static_cast<std::size_t>(bytes), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.gcount() != static_cast<std::streamsize>(text.size()))
        throw FileError(name + ": ended before its " + std::to_string(bytes) + " bytes were read");
    return text;
}

} // namespace firsthit
