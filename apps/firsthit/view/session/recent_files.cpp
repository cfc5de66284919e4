// recent_files.cpp - which files were looked at last.
#include "view/session/recent_files.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace firsthit::cli::view {

RecentFiles::RecentFiles(std::string path) : path_(std::move(path))
{
    if (path_.empty()) return;
    std::ifstream file(path_);
    for (std::string name; names_.size() < kMost && std::getline(file, name);)
        if (!name.empty()) names_.push_back(name);
}

void RecentFiles::add(const std::string& file)
{
    if (file == "-" || file.starts_with("builtin:") || file.find('\n') != std::string::npos) return;
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::absolute(file, failed);
    const std::string name = failed ? file : whole.lexically_normal().string();
    std::erase(names_, name);
    names_.insert(names_.begin(), name);
    if (names_.size() > kMost) names_.resize(kMost);
    if (path_.empty()) return;
    std::string text;
    for (const std::string& one : names_) text += one + "\n";
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), failed);
    try {
        write_file(path_, text);
    } catch (const Error&) {
        // A home that cannot be written: the list lasts for this run.
    }
}

std::string RecentFiles::usual_path()
{
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    if (state && *state) return std::string(state) + "/firsthit/recent";
    if (home && *home) return std::string(home) + "/.local/state/firsthit/recent";
    return {};
}

} // namespace firsthit::cli::view
