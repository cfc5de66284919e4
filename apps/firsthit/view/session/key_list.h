// key_list.h - the page of keys: what hands and keys do.
#pragma once

#include <vector>

namespace firsthit::cli::view {

/// In front of a session.
enum class Front { any, window, page };

/// One line; both texts are empty where a gap is.
struct KeyLine {
    const char* keys;
    const char* text;
    Front front = Front::any; // where it holds
};

/// All lines that hold in the window, or in the page of a browser, in order.
std::vector<KeyLine> keys_of(Front front);

} // namespace firsthit::cli::view
