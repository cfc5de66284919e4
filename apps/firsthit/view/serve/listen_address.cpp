// listen_address.cpp - where the page of `firsthit view --serve` is served.
#include "view/serve/listen_address.h"

#include "common/parse.h"
#include "common/usage.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>

#include <algorithm>
#include <cctype>

namespace firsthit::cli::view {
namespace {

bool is_of_family(std::string_view text, int family)
{
    std::array<unsigned char, sizeof(in6_addr)> address{};
    return inet_pton(family, std::string(text).c_str(), address.data()) == 1;
}

bool is_number(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(),
                                [](unsigned char c) { return std::isdigit(c) != 0; });
}

[[noreturn]] void refuse_address(const std::string& text)
{
    throw UsageError(fmt::format("'{}' is no address to serve at: accepted are ADDRESS:PORT, "
                                 "ADDRESS and PORT, as 127.0.0.1:8080, localhost, [::1]:8080, "
                                 "0.0.0.0:8080 or 8080",
        text));
}

} // namespace

bool is_ip_address(std::string_view text)
{
    return is_of_family(text, AF_INET) || is_of_family(text, AF_INET6);
}

ListenAddress parse_listen_address(const std::string& text)
{
    ListenAddress address;
    if (text.empty()) return address;
    std::string host = text, port;
    const std::size_t colon = text.rfind(':');
    if (is_number(text)) {
        host.clear();
        port = text;
    } else if (colon != std::string::npos && !text.ends_with(']')) {
        host = text.substr(0, colon);
        port = text.substr(colon + 1);
        if (!is_number(port)) refuse_address(text);
    }
    if (!port.empty()) {
        if (port.size() > 5 || std::stoul(port) > 65535) refuse_address(text);
        address.port = static_cast<std::uint16_t>(std::stoul(port));
    }
    if (host.empty() || host == "localhost") return address;
    const bool brackets = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (brackets) host = host.substr(1, host.size() - 2);
    if (!is_of_family(host, brackets ? AF_INET6 : AF_INET)) refuse_address(text);
    address.host = host;
    return address;
}

bool is_loopback(const std::string& host)
{
    return host == "::1" || (host.starts_with("127.") && is_of_family(host, AF_INET));
}

std::string with_port(const std::string& host, std::uint16_t port)
{
    const bool is_v6 = host.find(':') != std::string::npos;
    return is_v6 ? fmt::format("[{}]:{}", host, port) : fmt::format("{}:{}", host, port);
}

} // namespace firsthit::cli::view
