// http_connection.cpp - one connection of the web: a request and its answer.
#include "view/serve/http_connection.h"

#include "view/serve/page_files.h"
#include "view/serve/page_request.h"

#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <utility>

namespace firsthit::cli::view {
namespace {

/// Of a request, bytes; and how long it and its answer may take.
constexpr std::uint32_t kMostHeader = 8192;
constexpr std::chrono::seconds kMostRequest{10}, kMostAnswer{30};

std::string_view view_of(beast::string_view text)
{
    return {text.data(), text.size()};
}

PageRequest request_of(const HttpRequest& given)
{
    PageRequest request{.method = view_of(given.method_string()),
        .target = view_of(given.target()),
        .host = view_of(given[http::field::host]),
        .is_upgrade = boost::beast::websocket::is_upgrade(given)};
    if (const auto origin = given.find(http::field::origin); origin != given.end())
        request.origin = view_of(origin->value());
    return request;
}

HttpAnswer answer_of(const PageVerdict& verdict, std::string_view host)
{
    HttpAnswer answer{static_cast<http::status>(verdict.status), 11};
    std::string_view type = "text/plain; charset=utf-8";
    answer.body() = verdict.text + "\n";
    for (const PageFile& file : page_files()) {
        if (verdict.status != 200 || file.name != verdict.name) continue;
        answer.body() = file.text;
        type = content_type(file.name);
        const std::string policy = security_policy(host);
        answer.set("Content-Security-Policy", policy);
    }
    answer.set(http::field::content_type, beast::string_view(type.data(), type.size()));
    answer.set(http::field::cache_control, "no-store");
    answer.set("X-Content-Type-Options", "nosniff");
    answer.set("X-Frame-Options", "DENY");
    answer.set("Referrer-Policy", "no-referrer"); // the address holds the token
    answer.set("Cross-Origin-Resource-Policy", "same-origin");
    answer.set("Cross-Origin-Opener-Policy", "same-origin");
    answer.keep_alive(false);
    answer.prepare_payload();
    return answer;
}

/// What is said about a request that cannot be read; of status 0: nothing, the other side has gone.
PageVerdict verdict_of(beast::error_code error)
{
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
        return {431, "the request's header is too long"};
    if (error == http::error::body_limit || error == http::error::unexpected_body)
        return {413, "a request has no body"};
    if (error == http::error::end_of_stream || error == http::error::partial_message ||
        error.category() != http::make_error_code(http::error::bad_method).category())
        return {0, {}, {}};
    return {400, "the request is not of HTTP"};
}

} // namespace

HttpConnection::HttpConnection(tcp::socket socket, const Server& server)
    : stream_(std::move(socket)),
      server_(server),
      buffer_(kMostHeader)
{
    parser_.header_limit(kMostHeader);
    parser_.body_limit(0);
}

HttpConnection::~HttpConnection()
{
    server_.gone();
}

void HttpConnection::run()
{
    stream_.expires_after(kMostRequest);
    http::async_read(stream_, buffer_, parser_,
        [self = shared_from_this()](beast::error_code error, std::size_t) { self->answer(error); });
}

void HttpConnection::answer(beast::error_code error)
{
    if (error) {
        const PageVerdict verdict = verdict_of(error);
        if (verdict.status != 0) send(answer_of(verdict, {}));
        return;
    }
    const HttpRequest& request = parser_.get();
    const PageRequest asked = request_of(request);
    const PageVerdict verdict = judge(asked, server_.token);
    if (verdict.status == 200 && verdict.name == kSocketName)
        server_.opens_socket(std::move(stream_), request);
    else
        send(answer_of(verdict, asked.host));
}

void HttpConnection::send(HttpAnswer answer)
{
    answer_ = std::move(answer);
    stream_.expires_after(kMostAnswer);
    http::async_write(
        stream_, answer_, [self = shared_from_this()](beast::error_code, std::size_t) {
            beast::error_code ignored;
            self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        });
}

} // namespace firsthit::cli::view
