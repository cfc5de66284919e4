// session_files.cpp - files of a session: scenes that are opened and read again, pictures and films that are written.
#include "view/session/view_session.h"

#include "common/interrupt.h"
#include "common/usage.h"
#include "options/picture_options.h"
#include "view/frames/write_pixels.h"

#include <firsthit/error.h>
#include <firsthit/picture.h>

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace firsthit::cli::view {
namespace {

/// How often the times of files are looked at.
constexpr std::chrono::milliseconds kWatch{700};
/// How long it is said that something went well.
constexpr std::chrono::seconds kSaid{6};

/// The first free name in the working folder. ending  ".png"
std::string free_name(const char* ending)
{
    for (int k = 1;; ++k) {
        const std::string name = fmt::format("firsthit-{:03}{}", k, ending);
        if (!std::filesystem::exists(name)) return name;
    }
}

} // namespace

void ViewSession::load(const RenderOptions& options, bool keep)
{
    options_ = options;
    if (loading_.valid()) { // one file at a time
        next_load_ = {options, keep};
        return;
    }
    loading_ = std::async(std::launch::async, [options, keep, news = has_news_] {
        Loaded loaded;
        loaded.keep = keep;
        try {
            loaded.scene = std::make_shared<ViewScene>(options);
        } catch (const std::bad_alloc&) {
            loaded.error = "out of memory";
        } catch (const std::exception& error) {
            loaded.error = error.what();
        }
        news();
        return loaded;
    });
}

void ViewSession::take_loaded()
{
    if (!loading_.valid() ||
        loading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    const Loaded loaded = loading_.get();
    if (const auto next = std::exchange(next_load_, {})) {
        load(next->options, next->keep);
        return;
    }
    if (loaded.scene) {
        message_.text.clear();
        take_scene(loaded.scene, loaded.keep);
        return;
    }
    // The old scene stays, and what its lights are.
    options_ = scene_->options();
    state_.studio = scene_->in_studio();
    state_.environment = environment_;
    complain(loaded.error);
    changed(false);
}

void ViewSession::open(const std::string& file)
{
    RenderOptions options = options_;
    options.scene.name = file;
    options.scene.format.clear();
    options.scene.load.scene.clear();
    options.scene.pose = {};
    options.frames = {};
    CameraOptions camera; // that of the old scene is of no use; what is up may be another axis
    camera.size = options.camera.size;
    options.camera = camera;
    load(options, false);
}

void ViewSession::reload()
{
    load(options_, true);
}

/// Light that is part of the scene: it is read again.
void ViewSession::relight()
{
    RenderOptions options = options_;
    options.sky.studio = state_.studio;
    options.environment = given_environment_;
    if (state_.environment != EnvironmentChoice::given)
        options.environment.name =
            state_.environment == EnvironmentChoice::none ? "none" : "studio";
    load(options, true);
}

void ViewSession::watch_files(Clock::time_point now)
{
    if (now - last_watch_ < kWatch || loading_.valid()) return;
    last_watch_ = now;
    if (!scene_->has_changed()) return;
    scene_->note_times(); // a file that fails is tried again when it has changed again
    reload();
}

void ViewSession::say(const std::string& message)
{
    message_ = {message, Clock::now() + kSaid};
}

void ViewSession::complain(const std::string& message)
{
    message_ = {message, Clock::time_point::max()};
}

std::string ViewSession::message() const
{
    const std::string error = frames_.error();
    if (!error.empty()) return error;
    if (!message_.text.empty() && Clock::now() < message_.until) return message_.text;
    const std::shared_ptr<const ShownFrame> frame = latest();
    return frame ? frame->note : std::string();
}

void ViewSession::write_picture_at_rest(const std::string& path) const
{
    const std::shared_ptr<const ShownFrame> frame = latest();
    if (!frame || !is_at_rest(Clock::now()) || frame->request.number != number_)
        throw UsageError(fmt::format("{}: there is no picture to write: it is not at rest", path));
    if (frame->film.color.value.empty())
        throw UsageError(fmt::format("{}: there is no picture to write: choose look color", path));
    const RenderOptions& options = scene_->options();
    PictureChoices choices = options.picture;
    choices.format.clear();
    choices.dither = state_.dither;
    write_picture(frame->film, path, picture_options(choices, state_.tone, path));
}

void ViewSession::save_picture()
{
    const std::shared_ptr<const ShownFrame> frame = latest();
    if (!frame) return;
    const std::string file = free_name(".png");
    const bool whole = state_.look == Look::color && is_at_rest(Clock::now()) && !has_failed();
    if (whole)
        write_picture_at_rest(file);
    else
        write_pixels(frame->rgba, frame->width, frame->height, file);
    say(fmt::format(
        "wrote {}: {}", file, whole ? "the picture as render makes it" : "what is shown"));
}

void ViewSession::record_or_stop()
{
    if (recorder_) {
        recorder_->stop();
        return;
    }
    recorder_ = std::make_unique<FilmRecorder>(free_name(".mp4"), width_, height_);
    say(fmt::format("recording {}; shift + F12 ends it", recorder_->path()));
}

void ViewSession::record(Clock::time_point now)
{
    if (HoldInterrupts::is_pending()) wants_end_ = true;
    if (!recorder_) return;
    recorder_->show(latest(), now);
    if (!recorder_->is_done()) return;
    const std::string error = recorder_->error();
    if (error.empty())
        say(fmt::format("wrote {}: {:.1f} s", recorder_->path(), recorder_->length_s()));
    else
        complain(error);
    recorder_.reset();
}

} // namespace firsthit::cli::view
