// page_socket.cpp - the WebSocket of one page.
#include "view/serve/page_socket.h"

#include "common/usage.h"

#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <string_view>
#include <utility>

namespace firsthit::cli::view {
namespace {

namespace websocket = boost::beast::websocket;

/// A page that answers nothing for so long, not even the pings that browsers answer, is gone; so is one that reads
/// nothing.
constexpr std::chrono::seconds kMostSilence{20};
constexpr std::chrono::seconds kMostHandshake{10};

} // namespace

PageSocket::PageSocket(beast::tcp_stream stream, const Server& server)
    : socket_(std::move(stream)),
      server_(server)
{
    beast::get_lowest_layer(socket_).expires_never(); // the WebSocket has times of its own
    socket_.set_option(websocket::stream_base::timeout{kMostHandshake, kMostSilence, true});
    socket_.read_message_max(kMostMessage);
    socket_.auto_fragment(false);
}

void PageSocket::open(const HttpRequest& request)
{
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
        if (error) return self->leave();
        self->viewer_ = &self->server_.session.join();
        self->server_.changed();
        self->read();
    });
}

void PageSocket::read()
{
    socket_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
        if (error) return self->leave(); // too long, not of the protocol, silent, or closed
        self->take();
    });
}

void PageSocket::take()
{
    if (!viewer_) return;
    try {
        if (!socket_.got_text()) throw UsageError("the page's message is refused: it is no text");
        const std::string text = beast::buffers_to_string(buffer_.data());
        buffer_.consume(buffer_.size());
        server_.session.take(*viewer_, parse_client_message(text));
    } catch (const UsageError& error) {
        closes_ = true;
        server_.session.leave(*std::exchange(viewer_, nullptr));
        const std::string reason =
            std::string(error.what()).substr(0, 120); // the protocol's most is 123
        socket_.async_close({websocket::close_code::policy_error, reason},
            [self = shared_from_this()](beast::error_code) { self->leave(); });
        return;
    }
    server_.changed();
    read();
}

void PageSocket::write()
{
    if (!viewer_ || out_ || closes_) return;
    out_ = server_.session.next(*viewer_, Clock::now());
    if (!out_) return;
    socket_.binary(out_->is_picture);
    socket_.async_write(asio::buffer(*out_->bytes),
        [self = shared_from_this()](beast::error_code error, std::size_t) {
            self->out_.reset();
            if (error) return self->leave();
            self->write();
        });
}

void PageSocket::close()
{
    if (std::exchange(closes_, true)) return;
    socket_.async_close(websocket::close_code::going_away,
        [self = shared_from_this()](beast::error_code) { self->leave(); });
}

void PageSocket::leave()
{
    if (Viewer* viewer = std::exchange(viewer_, nullptr)) server_.session.leave(*viewer);
    beast::get_lowest_layer(socket_).close();
    server_.gone(*this);
}

} // namespace firsthit::cli::view
