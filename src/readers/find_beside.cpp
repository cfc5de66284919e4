// find_beside.cpp - the file that another file means by a name.
#include "readers/find_beside.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <system_error>

namespace firsthit {
namespace {

/// A guard: folders with more entries are not looked through.
constexpr std::size_t kMostEntries = 200'000;

bool is_regular(const std::filesystem::path& path)
{
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

bool same_letters(const std::string& a, const std::string& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
        [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The entry of a folder with that name in any case, the first by its name; empty where there is none.
std::filesystem::path entry_in_any_case(
    const std::filesystem::path& folder, const std::string& name)
{
    std::error_code error;
    std::filesystem::path found;
    std::size_t looked_at = 0;
    const std::filesystem::path where = folder.empty() ? "." : folder;
    for (std::filesystem::directory_iterator entry(where, error), end;
         !error && entry != end && looked_at < kMostEntries; entry.increment(error), ++looked_at) {
        const std::filesystem::path file = entry->path().filename();
        if (same_letters(file.string(), name) && (found.empty() || file < found)) found = file;
    }
    return found.empty() ? found : folder / found;
}

/// A name below a folder in any case, folder by folder; empty where there is none.
std::filesystem::path in_any_case(std::filesystem::path folder, const std::filesystem::path& name)
{
    if (name.is_absolute()) return {};
    for (const std::filesystem::path& part : name) {
        std::error_code error;
        std::filesystem::path next = folder / part;
        if (!std::filesystem::exists(next, error)) next = entry_in_any_case(folder, part.string());
        if (next.empty()) return {};
        folder = std::move(next);
    }
    return folder;
}

} // namespace

std::filesystem::path find_beside(const std::filesystem::path& folder, const std::string& file)
{
    std::string name = file;
    std::replace(name.begin(), name.end(), '\\', '/');
    for (const std::string& written : {file, name})
        if (is_regular(folder / written)) return folder / written;
    const std::string bare = name.substr(name.find_last_of("/:") + 1);
    if (is_regular(folder / bare)) return folder / bare;
    for (const std::string& written : {name, bare}) {
        if (written.empty()) continue;
        const std::filesystem::path found = in_any_case(folder, written);
        if (!found.empty() && is_regular(found)) return found;
    }
    return folder / file;
}

} // namespace firsthit
