// listen_address.h - where the page of `firsthit view --serve` is served.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace firsthit::cli::view {

struct ListenAddress {
    std::string host = "127.0.0.1"; // an address of this machine, in numbers
    std::uint16_t port = 0;         // 0: a free one
};

/// "", "PORT", "ADDRESS", "ADDRESS:PORT" or ":PORT", where ADDRESS is of IPv4, localhost, or of IPv6 in brackets.
/// throws  UsageError: what is accepted
ListenAddress parse_listen_address(const std::string& text);

/// Whether a text is an address in numbers, IPv4 or IPv6 without brackets.
bool is_ip_address(std::string_view text);

/// Whether only this machine can reach it.
bool is_loopback(const std::string& host);

/// "127.0.0.1:80", "[::1]:80"
std::string with_port(const std::string& host, std::uint16_t port);

} // namespace firsthit::cli::view
