// http_connection.h - one connection of the web: a request and its answer.
#pragma once

#include "view/serve/asio.h"

#include <boost/beast/http/parser.hpp>

#include <functional>
#include <memory>
#include <string>

namespace firsthit::cli::view {

/// Reads one request, within limits of size and time, and sends a file of the page, an error, or hands a WebSocket on.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
  public:
    struct Server {
        std::string token{};
        std::function<void(beast::tcp_stream, const HttpRequest&)> opens_socket{};
        std::function<void()> gone{}; // the connection is over, or has become a WebSocket
    };

    HttpConnection(tcp::socket socket, const Server& server);
    ~HttpConnection();
    HttpConnection(const HttpConnection&) = delete;
    HttpConnection& operator=(const HttpConnection&) = delete;

    void run();

  private:
    void answer(beast::error_code error);
    void send(HttpAnswer answer);

    beast::tcp_stream stream_;
    const Server& server_;
    beast::flat_buffer buffer_;
    http::request_parser<http::empty_body> parser_;
    HttpAnswer answer_;
};

} // namespace firsthit::cli::view
