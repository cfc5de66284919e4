// dae_numbers.h - numbers of COLLADA texts, as Assimp 5.2 reads them.
#pragma once

#include <string>

namespace firsthit {

/// A COLLADA text without the blanks between the end of a tag and a number: in colours and single numbers, as
/// "<color> 1 0 0 1</color>", they make Assimp 5.2 refuse the file.
std::string without_blanks_before_numbers(const std::string& xml);

} // namespace firsthit
