// token.cpp - the secret in the address of a served page.
#include "view/serve/token.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstddef>

namespace firsthit::cli::view {

std::string make_token()
{
    std::array<unsigned char, 16> bytes{};
    if (getentropy(bytes.data(), bytes.size()) != 0)
        throw Error("the system gives no entropy for the address of the page");
    std::string token;
    for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
    return token;
}

bool same_token(std::string_view a, std::string_view b)
{
    if (a.size() != b.size()) return false;
    volatile unsigned char different = 0; // so that the loop is not left early
    for (std::size_t k = 0; k < a.size(); ++k)
        different = static_cast<unsigned char>(
            different | (static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k])));
    return different == 0;
}

} // namespace firsthit::cli::view
