// test_data.h - scenes of others, which are no part of the project.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace firsthit {

/// A file below the folder that FIRSTHIT_TEST_DATA names; nothing where either is missing.
inline std::optional<std::filesystem::path> test_data(const std::string& name)
{
    const char* const folder = std::getenv("FIRSTHIT_TEST_DATA");
    if (folder == nullptr) return std::nullopt;
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    if (!std::filesystem::exists(path)) return std::nullopt;
    return path;
}

} // namespace firsthit
