// page_files.h - the files of the page, which the program has in itself.
#pragma once

#include <span>
#include <string_view>

namespace firsthit::cli::view {

struct PageFile {
    std::string_view name, text;
};

/// All of them, as they lie in page/.
std::span<const PageFile> page_files();

/// "text/html; charset=utf-8" and so on, by the name's ending.
std::string_view content_type(std::string_view name);

} // namespace firsthit::cli::view
