// file_identity.cpp - which file a path leads to, however it is spelled.
#include "io/file_identity.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <system_error>

namespace firsthit {

namespace fs = std::filesystem;

std::string follow_links(const std::string& path)
{
    std::error_code error;
    if (!fs::is_symlink(path, error)) return path;
    if (fs::exists(path, error)) {
        const fs::path real = fs::canonical(path, error);
        return error ? path : real.string();
    }
    // Nothing is at the end yet: step by step, as far as Linux goes.
    constexpr int kMostLinks = 40;
    fs::path place = path;
    for (int links = 0; links < kMostLinks; ++links) {
        const fs::path next = fs::read_symlink(place, error);
        if (error) return path;
        place = place.parent_path() / next;
        if (!fs::is_symlink(place, error)) return place.string();
    }
    return path;
}

std::string output_target(const std::string& path)
{
    std::error_code error;
    const fs::path end = follow_links(path);
    const fs::path whole = fs::weakly_canonical(fs::absolute(end, error), error);
    return error ? path : whole.string();
}

FileIdentity identity_of(const std::string& path)
{
    struct stat status {};
    if (stat(path.c_str(), &status) == 0) return {status.st_dev, status.st_ino, {}};
    return {0, 0, output_target(path)};
}

bool same_file(const std::string& a, const std::string& b)
{
    return identity_of(a) == identity_of(b);
}

void check_inputs_stay(std::span<const std::string> outputs, std::span<const std::string> inputs)
{
    std::map<FileIdentity, const std::string*> known;
    bool all_exist = true;
    for (const std::string& input : inputs) {
        const auto [entry, added] = known.try_emplace(identity_of(input), &input);
        all_exist = all_exist && entry->first.target.empty();
    }
    for (const std::string& output : outputs) {
        // A million frames that are not there yet need no long look.
        struct stat status {};
        if (all_exist && stat(output.c_str(), &status) != 0) continue;
        const auto found = known.find(identity_of(output));
        if (found != known.end())
            throw FileError(fmt::format(
                "{}: cannot write: it would replace the input '{}'", output, *found->second));
    }
}

} // namespace firsthit
