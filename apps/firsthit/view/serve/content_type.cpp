// content_type.cpp - what the files of the page are, in the words of the web.
#include "view/serve/page_files.h"

namespace firsthit::cli::view {

std::string_view content_type(std::string_view name)
{
    if (name.ends_with(".html")) return "text/html; charset=utf-8";
    if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
    if (name.ends_with(".css")) return "text/css; charset=utf-8";
    if (name.ends_with(".svg")) return "image/svg+xml";
    return "application/octet-stream";
}

} // namespace firsthit::cli::view
