// find_beside.h - the file that another file means by a name.
#pragma once

#include <filesystem>
#include <string>

namespace firsthit {

/// The file that a name means: as it is given, in a folder unless it is absolute; else its bare name in that
/// folder, as names often come from another computer. Where neither exists both are tried in upper and lower
/// case, because names come from systems that do not tell these apart. Where nothing is found it is the
/// first.
///
/// file  with / or \ between its folders
std::filesystem::path find_beside(const std::filesystem::path& folder, const std::string& file);

} // namespace firsthit
