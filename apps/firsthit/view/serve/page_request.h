// page_request.h - which requests of the web are answered, and with what.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace firsthit::cli::view {

/// What counts of a request.
struct PageRequest {
    std::string_view method{};                // "GET"
    std::string_view target{};                // "/TOKEN/page.js"
    std::string_view host{};                  // of the header of that name
    std::optional<std::string_view> origin{}; // of the header of that name
    bool is_upgrade = false;                  // to a WebSocket
};

/// The answer. Of status 200 the name says what is sent: a file of the page, or kSocketName for a WebSocket.
struct PageVerdict {
    int status = 200;
    std::string text{}; // of an error, a line to read
    std::string name{};
};

/// What the WebSocket of a page is called beside its files.
inline constexpr std::string_view kSocketName = "socket";

/// Refuses who does not know the token, and whom a foreign page has sent: the host has to be an address in numbers,
/// localhost or this machine's name, which no foreign name can be made to lead to unseen (DNS rebinding); and an origin
/// has to be this page's own. A wrong token is told nothing about what there is.
PageVerdict judge(const PageRequest& request, std::string_view token);

/// The header Content-Security-Policy of the page: it may load its own files and speak to its own host alone.
/// host  that judge() accepted
std::string security_policy(std::string_view host);

} // namespace firsthit::cli::view
