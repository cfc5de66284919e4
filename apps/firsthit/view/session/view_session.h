// view_session.h - one who looks at a scene: state, camera, actions and frames, without any window.
#pragma once

#include "view/session/camera_mover.h"
#include "view/frames/film_recorder.h"
#include "view/frames/frame_history.h"
#include "view/frames/frame_thread.h"
#include "view/session/recent_files.h"
#include "view/session/switches.h"

#include <glm/vec2.hpp>

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace firsthit::cli::view {

/// What the pointer's buttons are called.
enum class Button { left, middle, right };

/// A session. One thread calls it; a window, a script or a server is in front of it. No call waits for a frame.
/// Pixels are counted from the picture's top left.
class ViewSession {
  public:
    /// Reads the scene.
    /// has_news  called on another thread when there is something new to show
    /// throws    as ViewScene
    ViewSession(const RenderOptions& options, std::function<void()> has_news,
        RecentFiles recent = RecentFiles());
    ~ViewSession();

    // Input.
    void resize(int width, int height);
    void pointer_moves(double x, double y);
    void button(Button button, bool down, bool shift = false);
    void scroll(double steps);
    /// name  as docs/view.md lists them: "a", "1", "space", "shift+left", "f12"
    /// returns whether the key means something here
    bool key(const std::string& name, bool down);
    /// All keys and buttons are let go, as when the window loses the keyboard.
    void release_all();
    /// A button is let go without a click, as when who held it is gone.
    void release_button() { held_.reset(); }
    bool holds_button() const { return held_.has_value(); }
    /// throws  UsageError: no such switch or value
    void choose_switch(const std::string& name, const std::string& value);
    /// Shows another file with the same options, where it can be read.
    void open(const std::string& file);
    void reload();
    /// Says for some seconds what was done.
    void say(const std::string& message);
    /// Says what went wrong, until a scene is read or the key escape.
    void complain(const std::string& message);

    /// Lets time pass, and asks for the frame of now. To be called often while is_moving().
    void update(Clock::time_point now = Clock::now());
    /// A frame has come to the screen.
    void shown(const ShownFrame& frame, Clock::time_point when);
    /// Showing a frame takes so long of the processors that make frames, which are given less time then.
    void note_showing(double ms);

    // What there is to see.
    std::shared_ptr<const ShownFrame> latest() const { return frames_.latest(); }
    std::optional<Pick> latest_pick() const;
    const ViewState& state() const { return state_; }
    const ViewScene& scene() const { return *scene_; }
    const FrameHistory& history() const { return history_; }
    FrameHistory& history() { return history_; }
    std::uint64_t cancelled() const { return frames_.cancelled(); }
    /// The line of the corner: exact or what is missing, age, size.
    std::string corner(Clock::time_point now) const;
    /// What went wrong or was done last; empty: nothing to say.
    std::string message() const;
    /// The camera as options of `render`.
    std::string camera_options() const;
    bool wants_end() const { return wants_end_; }
    const std::vector<std::string>& recent_files() const { return recent_.names(); }
    bool is_recording() const { return recorder_ != nullptr; }
    /// A text that the window puts on the clipboard, once.
    std::optional<std::string> take_copied();

    /// Whether something moves, or a button that moves the camera is held.
    bool is_moving(Clock::time_point now) const;
    /// Whether the latest frame is the exact picture of the state, and nothing is under way.
    bool is_at_rest(Clock::time_point now) const;
    /// Whether the picture cannot be made; message() says why.
    bool has_failed() const { return frames_.error_number() == number_; }

    /// Writes firsthit-001.png, or the next free number: the picture of `render` where colours are at rest, else what
    /// is shown.
    void save_picture();
    /// Begins or ends firsthit-001.mp4, or the next free number: what is shown, without panels.
    void record_or_stop();

    /// Writes the picture at rest as `render` writes it, by the path's ending.
    /// throws  as write_picture; UsageError: the picture is not at rest or has no colours
    void write_picture_at_rest(const std::string& path) const;

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    void take_scene(std::shared_ptr<ViewScene> scene, bool keep);
    void take_loaded();
    void watch_files(Clock::time_point now);
    void load(const RenderOptions& options, bool keep);
    void relight();
    void record(Clock::time_point now);
    void changed(bool camera, bool input = true);
    void note_what_is_seen();
    CameraMover& mover(); // the camera, as the hand's own from now on
    void pass_time(double seconds);
    void fly(double seconds);
    void named_view(NamedView view);
    void frame_all();
    void frame_selected();
    void step(int frames);
    void click();
    void choose_next(const char* name, int by);
    void clamp_time();
    bool press(const std::string& name);
    FrameRequest request(Clock::time_point now) const;

    std::shared_ptr<ViewScene> scene_;
    RenderOptions options_;
    ViewState state_;
    int width_ = 1280, height_ = 720;
    std::optional<CameraMover> mover_; // none: the camera of the file or the options
    std::uint64_t number_ = 1;         // of the state
    Box seen_box_{};                   // of the last picture at rest
    double seen_t_ = 0;                // how far what is in its middle is; 0: nothing
    double showing_ms_ = 0;            // smoothed; see note_showing
    Clock::time_point moving_until_{}, last_update_{}, last_watch_{};
    glm::dvec2 pointer_{0}, pressed_at_{0};
    std::optional<Button> held_;
    bool shift_ = false, dragged_ = false, wants_end_ = false;
    bool picks_ = false;         // the pick is of the pointer
    std::set<std::string> keys_; // that are held
    struct Message {
        std::string text;
        Clock::time_point until{};
    };
    Message message_;
    std::optional<std::string> copied_;
    RecentFiles recent_;
    std::unique_ptr<FilmRecorder> recorder_;
    EnvironmentOptions given_environment_;
    EnvironmentChoice environment_ = EnvironmentChoice::given; // of scene_
    struct Loaded {
        std::shared_ptr<ViewScene> scene;
        std::string error;
        bool keep = false;
    };
    std::future<Loaded> loading_;
    struct Load {
        RenderOptions options;
        bool keep = false;
    };
    std::optional<Load> next_load_; // when the file in work is read
    FrameHistory history_;
    std::function<void()> has_news_;
    FrameThread frames_; // last: it calls has_news
};

} // namespace firsthit::cli::view
