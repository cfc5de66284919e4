// file_identity.h - which file a path leads to, however it is spelled.
#pragma once

#include <sys/types.h>

#include <compare>
#include <string>

namespace firsthit {

/// A file that exists is known by its device and number there, which all its links share; one that
/// does not by where a write would make it.
struct FileIdentity {
    dev_t device = 0;
    ino_t number = 0;
    std::string target; // of a file that does not exist; otherwise empty

    auto operator<=>(const FileIdentity&) const = default;
};

FileIdentity identity_of(const std::string& path);

/// Where a write to `path` ends: the file behind a chain of symbolic links, whether it is there or
/// not. `path` itself where it is no link, where the chain has no end, and where the end has no name
/// (/dev/stdout of a pipe).
std::string follow_links(const std::string& path);

} // namespace firsthit
