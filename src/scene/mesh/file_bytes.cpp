// file_bytes.cpp - a whole file in memory.
#include "scene/mesh/file_bytes.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace firsthit {

std::string read_bytes(const std::filesystem::path& path, std::size_t max_size)
{
    const std::string name = path.string();

    // A pipe or a device could block or never end.
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw FileError(fmt::format("{}: no such file", name));
    if (!std::filesystem::is_regular_file(status))
        throw FileError(fmt::format("{}: not a regular file", name));
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) throw FileError(fmt::format("{}: {}", name, error.message()));
    if (size > max_size)
        throw FileError(fmt::format("{}: {} bytes, at most {} are accepted", name, size, max_size));

    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
        std::fopen(name.c_str(), "rb"), std::fclose);
    if (!file) throw FileError(fmt::format("{}: {}", name, std::strerror(errno)));
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const std::size_t got = std::fread(bytes.data(), 1, bytes.size(), file.get());
    if (std::ferror(file.get()) != 0)
        throw FileError(fmt::format("{}: {}", name, std::strerror(errno)));
    bytes.resize(got);
    return bytes;
}

} // namespace firsthit
