// page_server.cpp - the page of `firsthit view --serve`: listens, lets time pass, ends.
#include "view/serve/page_server.h"

#include "common/output.h"
#include "common/usage.h"
#include "view/script/script_player.h"
#include "view/serve/http_connection.h"
#include "view/serve/page_socket.h"
#include "view/serve/token.h"

#include <firsthit/error.h>

#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace firsthit::cli::view {
namespace {

/// Pages that may look at once, and connections that have not become a page.
constexpr std::size_t kMostPages = 16, kMostConnections = 64;
/// How long pages are given to hear of the end.
constexpr std::chrono::milliseconds kFarewell{200};
/// After a connection that could not be had, as where there are too many files.
constexpr std::chrono::milliseconds kAcceptPause{200};

/// The name by which an address is reached.
std::string shown_host(const std::string& host)
{
    std::array<char, 256> name{};
    const bool any = host == "0.0.0.0" || host == "::";
    if (any && gethostname(name.data(), name.size() - 1) == 0 && name[0] != 0) return name.data();
    return host;
}

/// As of programs that nohup starts.
bool is_ignored(int signal)
{
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

class PageServer {
  public:
    explicit PageServer(const ViewOptions& options);
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    std::string address() const;
    void run();
    const ViewSession& session() const { return session_.session(); }

  private:
    void listen(const ListenAddress& where);
    void accept();
    void connect(tcp::socket socket);
    void open_socket(beast::tcp_stream stream, const HttpRequest& request);
    void look_soon();
    void look();
    void end();

    // What connections say when they end, which some do when the loop does.
    std::size_t connections_ = 0;
    HttpConnection::Server http_;
    asio::io_context loop_{1};
    std::atomic<bool> looks_soon_ = false; // a look is on its way
    ServedSession session_;                // calls look_soon() on other threads
    tcp::acceptor acceptor_{loop_};
    asio::signal_set signals_{loop_};
    asio::steady_timer timer_{loop_}, last_timer_{loop_}, accept_timer_{loop_};
    std::string host_;
    PageSocket::Server pages_;
    std::vector<std::shared_ptr<PageSocket>> sockets_;
};

PageServer::PageServer(const ViewOptions& options)
    : http_{.token = make_token(),
          .opens_socket =
              [this](beast::tcp_stream stream, const HttpRequest& request) {
                  open_socket(std::move(stream), request);
              },
          .gone = [this] { --connections_; }},
      session_(options, [this] { look_soon(); }),
      pages_{.session = session_,
          .changed = [this] { look_soon(); },
          .gone =
              [this](const PageSocket& gone) {
                  std::erase_if(sockets_, [&](const auto& one) { return one.get() == &gone; });
                  look_soon(); // the others are told how many look
              }}
{
    listen(*options.serve);
    accept();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(signal)) signals_.add(signal);
    signals_.async_wait([this](beast::error_code error, int) {
        if (!error) end();
    });
    look();
}

void PageServer::listen(const ListenAddress& where)
{
    beast::error_code error;
    const tcp::endpoint endpoint(asio::ip::make_address(where.host), where.port);
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
    if (error)
        throw DeviceError(fmt::format(
            "no page can be served at {}: {}", with_port(where.host, where.port), error.message()));
    host_ = where.host;
}

std::string PageServer::address() const
{
    return fmt::format("http://{}/{}/",
        with_port(shown_host(host_), acceptor_.local_endpoint().port()), http_.token);
}

void PageServer::accept()
{
    acceptor_.async_accept([this](beast::error_code error, tcp::socket socket) {
        if (error == asio::error::operation_aborted) return;
        if (!error) {
            connect(std::move(socket));
            accept();
            return;
        }
        accept_timer_.expires_after(kAcceptPause);
        accept_timer_.async_wait([this](beast::error_code ends) {
            if (!ends) accept();
        });
    });
}

void PageServer::connect(tcp::socket socket)
{
    if (connections_ >= kMostConnections) return; // it is closed
    beast::error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    ++connections_;
    std::make_shared<HttpConnection>(std::move(socket), http_)->run();
}

void PageServer::open_socket(beast::tcp_stream stream, const HttpRequest& request)
{
    if (sockets_.size() >= kMostPages) return; // it is closed
    sockets_.push_back(std::make_shared<PageSocket>(std::move(stream), pages_));
    sockets_.back()->open(request);
}

/// From any thread: one look for many news.
void PageServer::look_soon()
{
    if (looks_soon_.exchange(true)) return;
    asio::post(loop_, [this] { look(); });
}

void PageServer::look()
{
    looks_soon_ = false;
    const Clock::time_point now = Clock::now();
    session_.update(now);
    const auto sockets = sockets_; // writing may end one
    for (const auto& socket : sockets) socket->write();
    timer_.expires_after(session_.pause(now));
    timer_.async_wait([this](beast::error_code error) {
        if (!error) look();
    });
}

void PageServer::end()
{
    acceptor_.close();
    const auto sockets = sockets_;
    for (const auto& socket : sockets) socket->close();
    last_timer_.expires_after(sockets.empty() ? std::chrono::milliseconds(0) : kFarewell);
    last_timer_.async_wait([this](beast::error_code) { loop_.stop(); });
}

void PageServer::run()
{
    loop_.run();
}

} // namespace

int serve_page(const ViewOptions& options)
{
    PageServer server(options);
    if (!is_loopback(options.serve->host))
        print_warnings({"other machines can reach this page, and nothing is encrypted: whoever has "
                        "its address, or sees it pass, can look and choose"});
    print(fmt::format("{}\nOpen this in a browser; Ctrl-C ends it.\n", server.address()));
    server.run();
    if (options.measure) print(measured(server.session()));
    return kExitDone;
}

} // namespace firsthit::cli::view
