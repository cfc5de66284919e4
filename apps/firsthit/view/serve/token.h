// token.h - the secret in the address of a served page: who knows it may look.
#pragma once

#include <string>
#include <string_view>

namespace firsthit::cli::view {

/// 128 bits of the system's entropy as 32 hexadecimal digits. throws  Error: the system gives none
std::string make_token();

/// Compares in a time that does not depend on where two texts of one length differ.
bool same_token(std::string_view a, std::string_view b);

} // namespace firsthit::cli::view
