// page_socket.h - the WebSocket of one page.
#pragma once

#include "view/serve/asio.h"
#include "view/serve/served_session.h"

#include <boost/beast/websocket/stream.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace firsthit::cli::view {

/// Reads what the page says, one message at a time, and writes what the session has for it, one message at a time. It
/// lives as long as its socket, and outlives neither the session nor the thread's loop.
class PageSocket : public std::enable_shared_from_this<PageSocket> {
  public:
    /// What a socket and the server have to do with one another.
    struct Server {
        ServedSession& session;
        std::function<void()> changed{};               // a message has changed the session
        std::function<void(const PageSocket&)> gone{}; // the page is gone
    };

    PageSocket(beast::tcp_stream stream, const Server& server);

    /// Answers the request that asks for a WebSocket.
    void open(const HttpRequest& request);
    /// Writes what there is, if nothing is being written.
    void write();
    /// Tells the page that the server ends.
    void close();

  private:
    void read();
    void take();
    void leave();

    boost::beast::websocket::stream<beast::tcp_stream> socket_;
    const Server& server_;
    Viewer* viewer_ = nullptr; // once it is open, until it is gone
    beast::flat_buffer buffer_;
    std::optional<Outgoing> out_; // being written
    bool closes_ = false;
};

} // namespace firsthit::cli::view
