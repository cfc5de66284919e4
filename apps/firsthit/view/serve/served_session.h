// served_session.h - a session that several pages look at.
#pragma once

#include "view/serve/client_message.h"
#include "view/serve/picture_encoder.h"
#include "view/view_options.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace firsthit::cli::view {

/// Bytes that go to a page.
struct Outgoing {
    bool is_picture = false; // else text
    std::shared_ptr<const std::string> bytes{};
};

/// One page: what it has been sent, and what its hand holds.
class Viewer {
    friend class ServedSession;
    std::shared_ptr<const std::string> description_;
    std::string status_;
    Clock::time_point status_time_{}, bars_time_{};
    std::uint64_t bars_ = 0;            // frames that it was told of
    std::uint32_t sent_ = 0, seen_ = 0; // numbers of pictures
    std::deque<std::string> texts_;     // to it alone
    std::set<std::string> keys_;        // that it holds
};

/// Each page gets the newest picture when it has shown the last one, and nothing is kept for a slow one. One thread calls
/// all functions. Nothing that a page says reads or writes a file but the scene's own.
class ServedSession {
  public:
    /// has_news  called on other threads: update() is to be called, and next() for every viewer
    /// throws    as ViewSession
    ServedSession(const ViewOptions& options, const std::function<void()>& has_news);

    Viewer& join();
    void leave(const Viewer& viewer);
    std::size_t viewers() const { return viewers_.size(); }

    /// Does what a page says. What the session does not accept is told to the page.
    /// throws  UsageError: a message that no page of ours sends
    void take(Viewer& viewer, const ClientMessage& message);

    /// Lets time pass. Without a viewer nothing is made.
    void update(Clock::time_point now);
    /// When update() is to be called again without news.
    Clock::duration pause(Clock::time_point now) const;

    /// What a page is to be sent now, whose last message has been written; none: nothing.
    std::optional<Outgoing> next(Viewer& viewer, Clock::time_point now);

    const ViewSession& session() const { return session_; }

  private:
    void press(Viewer& viewer, const KeyMessage& key);
    void press(const Viewer& viewer, const ButtonMessage& button);
    void let_go(const Viewer& viewer);
    void choose(Viewer& viewer, const ChooseMessage& chosen);
    bool awaits_picture(const Viewer& viewer) const { return viewer.seen_ == viewer.sent_; }
    void encode(Clock::time_point now);

    ViewSession session_;
    PictureEncoder encoder_;
    std::list<Viewer> viewers_;
    const Viewer* holds_ = nullptr; // whose hand holds a button
    bool follows_pages_ = false;    // the picture has the size that pages ask for
    double fps_limit_ = 0;
    std::shared_ptr<const std::string> description_;
    const ViewScene* described_ = nullptr;
    std::uint32_t number_ = 0; // of the picture that was wanted last
    std::shared_ptr<const ShownFrame> wanted_;
    bool wanted_lossless_ = false;
    Clock::time_point wanted_time_{};
    std::shared_ptr<const ShownFrame> shown_;
};

} // namespace firsthit::cli::view
