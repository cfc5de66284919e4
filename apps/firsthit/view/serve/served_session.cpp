// served_session.cpp - a session that several pages look at.
#include "view/serve/served_session.h"

#include "common/usage.h"
#include "view/serve/session_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace firsthit::cli::view {
namespace {

/// The least time between two messages of one kind to a page, while something moves.
constexpr std::chrono::milliseconds kStatusPause{50}, kBarsPause{100};
/// How often the session is looked after: while something moves, and at rest.
constexpr std::chrono::milliseconds kMovingPause{4}, kRestPause{100};
/// Texts that wait for one page: a page that asks without reading gets the last ones.
constexpr std::size_t kMostTexts = 8;
/// A page asks for less than this many keys at once.
constexpr std::size_t kMostKeys = 32;

template <class... Ts>
struct Cases : Ts... {
    using Ts::operator()...;
};
template <class... Ts>
Cases(Ts...) -> Cases<Ts...>;

/// Keys that write files or end a session belong to the one who sits at the machine; panels are each page's own.
bool is_for_pages(const std::string& key)
{
    static constexpr std::array<std::string_view, 9> kNot{
        "f12", "shift+f12", "tab", "b", "i", "?", "f1", "shift+?", "shift+/"};
    return std::find(kNot.begin(), kNot.end(), key) == kNot.end();
}

} // namespace

ServedSession::ServedSession(const ViewOptions& options, const std::function<void()>& has_news)
    : session_(options.picture, has_news),
      encoder_(has_news),
      follows_pages_(!options.size_given),
      fps_limit_(options.fps_limit)
{
    const Size size = options.picture.camera.pixels();
    session_.resize(size.width, size.height);
    session_.choose_switch("rate", fmt::format("{}", options.rate));
}

Viewer& ServedSession::join()
{
    return viewers_.emplace_back();
}

void ServedSession::leave(const Viewer& viewer)
{
    let_go(viewer);
    viewers_.remove_if([&](const Viewer& one) { return &one == &viewer; });
}

void ServedSession::let_go(const Viewer& viewer)
{
    for (const std::string& key : viewer.keys_) session_.key(key, false);
    if (holds_ != &viewer) return;
    holds_ = nullptr;
    session_.release_button();
}

void ServedSession::press(Viewer& viewer, const KeyMessage& key)
{
    if (!is_for_pages(key.name)) throw UsageError("the page's key is refused");
    if (key.down && viewer.keys_.size() < kMostKeys) viewer.keys_.insert(key.name);
    if (!key.down) viewer.keys_.erase(key.name);
    session_.key(key.name, key.down);
    if (const std::optional<std::string> copied = session_.take_copied())
        viewer.texts_.push_back(text_message("copied", *copied));
}

void ServedSession::press(const Viewer& viewer, const ButtonMessage& button)
{
    if (holds_ && holds_ != &viewer) return; // another hand has the camera
    session_.button(button.button, button.down, button.shift);
    holds_ = session_.holds_button() ? &viewer : nullptr;
}

void ServedSession::choose(Viewer& viewer, const ChooseMessage& chosen)
{
    try {
        session_.choose_switch(chosen.name, chosen.value);
    } catch (const UsageError& error) {
        viewer.texts_.push_back(text_message("refused", error.what()));
    }
}

void ServedSession::take(Viewer& viewer, const ClientMessage& message)
{
    const Cases cases{
        [&](const MoveMessage& move) {
            if (!holds_ || holds_ == &viewer) session_.pointer_moves(move.x, move.y);
        },
        [&](const ButtonMessage& button) { press(viewer, button); },
        [&](const ScrollMessage& scroll) { session_.scroll(scroll.steps); },
        [&](const KeyMessage& key) { press(viewer, key); },
        [&](const ReleaseMessage&) {
            let_go(viewer);
            viewer.keys_.clear();
        },
        [&](const ChooseMessage& chosen) { choose(viewer, chosen); },
        [&](const ResizeMessage& size) {
            // One picture for all: the page that was there first says how large it is.
            if (follows_pages_ && &viewer == &viewers_.front())
                session_.resize(size.width, size.height);
        },
        [&](const SeenMessage& seen) {
            if (seen.number != viewer.sent_)
                throw UsageError("the page's message is refused: a picture that it was not sent");
            viewer.seen_ = viewer.sent_;
        },
    };
    std::visit(cases, message);
    while (viewer.texts_.size() > kMostTexts) viewer.texts_.pop_front();
}

Clock::duration ServedSession::pause(Clock::time_point now) const
{
    const bool busy = !viewers_.empty() && !session_.is_at_rest(now);
    return busy ? kMovingPause : kRestPause;
}

/// Has the newest frame encoded, if somebody waits for it: what moves with loss, what rests without.
void ServedSession::encode(Clock::time_point now)
{
    const std::shared_ptr<const ShownFrame> frame = session_.latest();
    const bool awaited = std::any_of(viewers_.begin(), viewers_.end(),
        [this](const Viewer& viewer) { return awaits_picture(viewer); });
    if (!frame || !awaited) return;
    const bool lossless = session_.is_at_rest(now);
    if (frame == wanted_ && (wanted_lossless_ || !lossless)) return;
    if (fps_limit_ > 0 && !lossless &&
        now - wanted_time_ < std::chrono::duration<double>(1 / fps_limit_))
        return;
    wanted_ = frame;
    wanted_lossless_ = lossless;
    wanted_time_ = now;
    encoder_.want(++number_, frame, lossless);
}

void ServedSession::update(Clock::time_point now)
{
    if (viewers_.empty()) return;
    session_.update(now);
    if (described_ != &session_.scene()) {
        described_ = &session_.scene();
        description_ = std::make_shared<const std::string>(described(session_));
    }
    encode(now);
    const std::shared_ptr<const EncodedPicture> picture = encoder_.latest();
    if (!picture || picture->frame == shown_) return;
    session_.note_showing(picture->ms);
    session_.shown(*picture->frame, now);
    shown_ = picture->frame;
}

std::optional<Outgoing> ServedSession::next(Viewer& viewer, Clock::time_point now)
{
    const auto text = [](std::string said) {
        return Outgoing{false, std::make_shared<const std::string>(std::move(said))};
    };
    if (viewer.description_ != description_) {
        viewer.description_ = description_;
        return Outgoing{false, description_};
    }
    if (!viewer.texts_.empty()) {
        std::string first = std::move(viewer.texts_.front());
        viewer.texts_.pop_front();
        return text(std::move(first));
    }
    const std::shared_ptr<const EncodedPicture> picture = encoder_.latest();
    if (picture && awaits_picture(viewer) && picture->number > viewer.sent_) {
        viewer.sent_ = picture->number;
        return Outgoing{true, picture->bytes};
    }
    const bool rests = session_.is_at_rest(now);
    if (rests || now - viewer.status_time_ >= kStatusPause) {
        std::string status = status_of(session_, now, viewers_.size());
        if (status != viewer.status_) {
            viewer.status_ = status;
            viewer.status_time_ = now;
            return text(std::move(status));
        }
    }
    const std::uint64_t frames = session_.history().count();
    if (frames > viewer.bars_ && now - viewer.bars_time_ >= kBarsPause) {
        std::string bars = bars_of(session_, now, viewer.bars_);
        viewer.bars_ = frames;
        viewer.bars_time_ = now;
        return text(std::move(bars));
    }
    return {};
}

} // namespace firsthit::cli::view
