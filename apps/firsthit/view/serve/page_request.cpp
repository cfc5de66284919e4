// page_request.cpp - which requests of the web are answered, and with what.
#include "view/serve/page_request.h"

#include "view/serve/listen_address.h"
#include "view/serve/page_files.h"
#include "view/serve/token.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace firsthit::cli::view {
namespace {

/// The machine's name; empty: none.
std::string machine_name()
{
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) return {};
    return name.data();
}

bool same_name(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
        [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool is_port(std::string_view text)
{
    return !text.empty() && text.size() <= 5 &&
           std::all_of(text.begin(), text.end(), [](char c) { return '0' <= c && c <= '9'; });
}

/// Whether a Host leads here whatever a name server says. Its port is free: a tunnel may have another.
bool is_own_host(std::string_view host)
{
    std::string_view name = host;
    if (host.starts_with('[')) {
        const std::size_t end = host.find(']');
        if (end == std::string_view::npos) return false;
        name = host.substr(1, end - 1);
        const std::string_view rest = host.substr(end + 1);
        if (!rest.empty() && !(rest[0] == ':' && is_port(rest.substr(1)))) return false;
        return is_ip_address(name) && name.find(':') != std::string_view::npos;
    }
    if (const std::size_t colon = host.find(':'); colon != std::string_view::npos) {
        name = host.substr(0, colon);
        if (!is_port(host.substr(colon + 1))) return false;
    }
    if (name.empty()) return false;
    return is_ip_address(name) || same_name(name, "localhost") || same_name(name, machine_name());
}

bool is_own_origin(std::string_view origin, std::string_view host)
{
    for (const std::string_view scheme : {"http://", "https://"}) // the latter by a proxy
        if (origin.starts_with(scheme) && same_name(origin.substr(scheme.size()), host))
            return true;
    return false;
}

} // namespace

PageVerdict judge(const PageRequest& request, std::string_view token)
{
    if (!is_own_host(request.host))
        return {403, "this host is not served: use its address in numbers, or localhost"};
    if (request.origin && !is_own_origin(*request.origin, request.host))
        return {403, "requests of other pages are not answered"};
    const std::string_view target = request.target;
    const std::size_t slash = target.find('/', 1);
    const std::string_view shown =
        target.empty() ? target
                       : target.substr(1, slash == std::string_view::npos ? slash : slash - 1);
    if (!target.starts_with('/') || !same_token(shown, token))
        return {403, "the address is not the one that firsthit printed"};
    if (request.method != "GET") return {405, "only GET is answered"};
    if (slash == std::string_view::npos) return {404, "the address ends with /"};
    std::string name(target.substr(slash + 1));
    if (name.empty()) name = "index.html";
    if (name == kSocketName)
        return request.is_upgrade ? PageVerdict{.name = name}
                                  : PageVerdict{426, "this is a WebSocket"};
    if (request.is_upgrade) return {400, "this is no WebSocket"};
    for (const PageFile& file : page_files())
        if (file.name == name) return {.name = name};
    return {404, "there is no such file"};
}

std::string security_policy(std::string_view host)
{
    return fmt::format("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' "
                       "blob:; connect-src 'self' ws://{0} wss://{0}; base-uri 'none'; form-action "
                       "'none'; frame-ancestors 'none'",
        host);
}

} // namespace firsthit::cli::view
