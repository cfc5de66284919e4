// serve_requests_test.cpp - whom the page's server answers: addresses, tokens, hosts, origins, names.
#include "view/serve/listen_address.h"
#include "view/serve/page_files.h"
#include "view/serve/page_request.h"
#include "view/serve/token.h"

#include "common/usage.h"
#include "message_of.h"

#include <gtest/gtest.h>

#include <set>

namespace firsthit::cli::view {
namespace {

constexpr const char* kToken = "0123456789abcdef0123456789abcdef";

PageRequest request_for(std::string_view target)
{
    return {.method = "GET", .target = target, .host = "127.0.0.1:8080"};
}

int status_of_target(const std::string& target)
{
    return judge(request_for(target), kToken).status;
}

TEST(ListenAddress, ReadsAddressesAndPorts)
{
    const auto is = [](const char* text, const char* host, int port) {
        const ListenAddress read = parse_listen_address(text);
        EXPECT_EQ(read.host, host) << text;
        EXPECT_EQ(read.port, port) << text;
    };
    is("", "127.0.0.1", 0);
    is("8080", "127.0.0.1", 8080);
    is(":8080", "127.0.0.1", 8080);
    is("localhost", "127.0.0.1", 0);
    is("localhost:80", "127.0.0.1", 80);
    is("0.0.0.0:65535", "0.0.0.0", 65535);
    is("10.1.2.3", "10.1.2.3", 0);
    is("[::1]", "::1", 0);
    is("[::1]:8080", "::1", 8080);
    EXPECT_EQ(with_port("::1", 80), "[::1]:80");
    EXPECT_EQ(with_port("10.1.2.3", 80), "10.1.2.3:80");
}

TEST(ListenAddress, RefusesOthers)
{
    for (const char* text : {"nowhere", "nowhere:1", "1.2.3:4", "1.2.3.4.5",
             "1.2.3.4:", "1.2.3.4:x", "1.2.3.4:-1", "1.2.3.4:65536", "99999999999999999999", "::1",
             "[::1", "[::1]x", "[]:1", "[1.2.3.4]:1", "a b:1", "1.2.3.4:8080/"})
        EXPECT_NE(
            message_of<UsageError>([&] { (void)parse_listen_address(text); }).find("no address"),
            std::string::npos)
            << text;
}

TEST(ListenAddress, KnowsWhatOnlyThisMachineReaches)
{
    for (const char* host : {"127.0.0.1", "127.9.9.9", "::1"})
        EXPECT_TRUE(is_loopback(host)) << host;
    for (const char* host : {"0.0.0.0", "::", "10.1.2.3", "128.0.0.1", "127.example"})
        EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(PageToken, IsNewEachTimeAndCompared)
{
    std::set<std::string> tokens;
    for (int k = 0; k < 100; ++k) {
        const std::string token = make_token();
        EXPECT_EQ(token.size(), 32u);
        EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos) << token;
        tokens.insert(token);
    }
    EXPECT_EQ(tokens.size(), 100u);
    EXPECT_TRUE(same_token(kToken, kToken));
    std::string other = kToken;
    for (std::size_t k = 0; k < other.size(); ++k) { // any place counts
        std::string changed = kToken;
        changed[k] = 'x';
        EXPECT_FALSE(same_token(changed, kToken)) << k;
    }
    EXPECT_FALSE(same_token(other + "0", kToken));
    EXPECT_FALSE(same_token("", kToken));
}

TEST(PageRequest, GivesFilesToWhoKnowsTheToken)
{
    const std::string base = std::string("/") + kToken + "/";
    EXPECT_EQ(judge(request_for(base), kToken).name, "index.html");
    for (const PageFile& file : page_files()) {
        const PageVerdict verdict = judge(request_for(base + std::string(file.name)), kToken);
        EXPECT_EQ(verdict.status, 200) << file.name;
        EXPECT_EQ(verdict.name, file.name);
        EXPECT_FALSE(file.text.empty()) << file.name;
        EXPECT_NE(content_type(file.name), "application/octet-stream") << file.name;
    }
    for (const char* name :
        {"none.js", "../main.js", "main.js?x", "%6dain.js", "/", "main.js/", ".."})
        EXPECT_EQ(status_of_target(base + name), 404) << name;
    EXPECT_EQ(status_of_target(std::string("/") + kToken), 404);
    EXPECT_EQ(status_of_target(base + "socket"), 426);
}

TEST(PageRequest, RefusesWrongTokens)
{
    for (const std::string target : {"", "/", "*", "//", "/main.js", "/socket",
             "/0123456789abcdef0123456789abcde/", "/0123456789abcdef0123456789abcdeF/",
             "/0123456789abcdef0123456789abcdef0/", "0123456789abcdef0123456789abcdef/",
             "/x/0123456789abcdef0123456789abcdef/", "//0123456789abcdef0123456789abcdef/"})
        EXPECT_EQ(status_of_target(target), 403) << target;
}

TEST(PageRequest, RefusesForeignHostsAndOrigins)
{
    PageRequest request = request_for("/0123456789abcdef0123456789abcdef/socket");
    request.is_upgrade = true;
    const auto with_host = [&](std::string_view host) {
        PageRequest asked = request;
        asked.host = host;
        return judge(asked, kToken).status;
    };
    for (const char* host : {"127.0.0.1", "127.0.0.1:1", "localhost", "LocalHost:8080",
             "10.1.2.3:80", "[::1]", "[::1]:80", "[fe80::1]:80"})
        EXPECT_EQ(with_host(host), 200) << host;
    for (const char* host : {"", ":80", "evil.example", "localhost.evil.example", "evil.example:80",
             "127.0.0.1.evil.example", "127.0.0.1:80:80", "127.0.0.1:x", "127.0.0.1:", "[::1",
             "[127.0.0.1]", "[::1]x", "::1", "127.1", "0x7f000001", "127.0.0.1 ; img-src *"})
        EXPECT_EQ(with_host(host), 403) << host;
    const auto with_origin = [&](std::string_view origin) {
        PageRequest asked = request;
        asked.origin = origin;
        return judge(asked, kToken).status;
    };
    for (const char* origin : {"http://127.0.0.1:8080", "https://127.0.0.1:8080"})
        EXPECT_EQ(with_origin(origin), 200) << origin;
    for (const char* origin :
        {"", "null", "127.0.0.1:8080", "http://127.0.0.1", "http://127.0.0.1:80",
            "http://localhost:8080", "http://evil.example", "http://127.0.0.1:8080.evil.example",
            "ftp://127.0.0.1:8080", "http://127.0.0.1:8080/"})
        EXPECT_EQ(with_origin(origin), 403) << origin;
    request.method = "POST";
    EXPECT_EQ(judge(request, kToken).status, 405);
}

TEST(PageRequest, PolicyAllowsNothingForeign)
{
    const std::string policy = security_policy("127.0.0.1:8080");
    EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
    EXPECT_NE(policy.find("ws://127.0.0.1:8080"), std::string::npos);
    for (const char* never : {"unsafe", "*", "data:"})
        EXPECT_EQ(policy.find(never), std::string::npos) << never;
    for (const PageFile& file :
        page_files()) { // nothing comes from elsewhere, and no script stands in the page
        EXPECT_EQ(file.text.find("https://"), std::string::npos) << file.name;
        EXPECT_EQ(file.text.find("innerHTML"), std::string::npos) << file.name;
        EXPECT_EQ(file.text.find(" style=\""), std::string::npos) << file.name;
    }
}

} // namespace
} // namespace firsthit::cli::view
