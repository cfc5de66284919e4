// view_command.cpp - `firsthit view`: a window, or a page, to look at a scene, and at how its picture is made.
#include "view/view_command.h"

#include "common/output.h"
#include "common/usage.h"
#include "view/script/script_player.h"
#include "view/serve/page_server.h"
#include "view/session/view_session.h"
#include "view/window/window.h"

#include <firsthit/error.h>

#include <condition_variable>
#include <memory>
#include <mutex>

namespace firsthit::cli {
namespace {

/// News from the thread of frames, for one who waits.
class News {
  public:
    void arrive()
    {
        {
            const std::lock_guard lock(mutex_);
            arrived_ = true;
        }
        wakes_.notify_all();
    }

    void wait(std::chrono::milliseconds most)
    {
        std::unique_lock lock(mutex_);
        wakes_.wait_for(lock, most, [this] { return arrived_; });
        arrived_ = false;
    }

  private:
    std::mutex mutex_;
    std::condition_variable wakes_;
    bool arrived_ = false;
};

/// Plays a script to its end without a window.
void play(view::ViewSession& session, view::ScriptPlayer& script, News& news)
{
    view::SessionInput input(session);
    std::shared_ptr<const view::ShownFrame> last;
    bool goes_on = true;
    while (goes_on && !session.wants_end()) {
        news.wait(std::chrono::milliseconds(4));
        const auto now = view::Clock::now();
        session.update(now);
        if (const auto frame = session.latest(); frame && frame != last) {
            session.shown(*frame, now);
            last = frame;
        }
        goes_on = script.step(session, input, now);
    }
}

} // namespace

int run_view(const ViewOptions& given)
{
    ViewOptions options = given;
    check(options);
    if (options.serve) return view::serve_page(options);
    std::unique_ptr<view::ScriptPlayer> script;
    if (!options.script.empty())
        script = std::make_unique<view::ScriptPlayer>(
            view::parse_script(view::read_text(options.script), options.script), options.script);
    if (options.no_window) {
        News news;
        view::ViewSession session(options.picture, [&news] { news.arrive(); });
        session.resize(
            options.picture.camera.pixels().width, options.picture.camera.pixels().height);
        session.choose_switch("rate", std::to_string(options.rate));
        play(session, *script, news);
        if (!options.screenshot.empty()) view::SessionInput(session).screenshot(options.screenshot);
        if (options.measure) print(view::measured(session));
        return kExitDone;
    }
    return view::show_window(options, script.get());
}

} // namespace firsthit::cli
