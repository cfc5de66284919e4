// renderer.cpp - renderers as Python uses them: without the interpreter's lock, stopped by Ctrl-C.
#include "renderer.h"

#include "arrays.h"
#include "interpreter.h"

#include <firsthit/error.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <shared_mutex>
#include <stop_token>
#include <thread>

namespace firsthit::python {
namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

const char* name_of(Engine engine)
{
    return engine == Engine::hybrid ? "hybrid" : engine == Engine::gpu ? "gpu" : "cpu";
}

/// Whether a frame looks at lights at all.
bool needs_lights(const Settings& settings)
{
    return settings.color ||
           std::find(settings.aovs.begin(), settings.aovs.end(), Aov::lit) != settings.aovs.end();
}

bool follows_camera(const std::vector<Light>& lights)
{
    return std::any_of(lights.begin(), lights.end(), [](const Light& l) { return l.on_camera; });
}

/// Asks, now and then, whether the user pressed Ctrl-C, and tells how far the frame is.
class Watch {
  public:
    explicit Watch(py::object progress) : progress_(std::move(progress)) {}

    /// Called without the interpreter's lock.
    void operator()(double share)
    {
        check_ending();
        const auto now = Clock::now();
        if (share < 1 && now - last_ < std::chrono::milliseconds(20)) return;
        if (share >= 1 && progress_.is_none()) return;
        last_ = now;
        const Locked locked;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (!progress_.is_none()) progress_(share);
    }

  private:
    py::object progress_;
    Clock::time_point last_ = Clock::now();
};

/// (x, y, width, height) from the picture's top left.
std::array<int, 4> region_of(const py::object& object)
{
    if (!py::isinstance<py::sequence>(object) || py::len(object) != 4)
        throw py::type_error("region: got " + std::string(py::repr(object)) +
                             ": accepted is (x, y, width, height) from the picture's top left");
    const auto given = py::reinterpret_borrow<py::sequence>(object);
    return {whole_number(given[0], "region: x", 0, kMostPixels),
        whole_number(given[1], "region: y", 0, kMostPixels),
        whole_number(given[2], "region: width", 1, kMostPixels),
        whole_number(given[3], "region: height", 1, kMostPixels)};
}

/// What `render` is given beside world, camera and settings, all of it optional.
Shot shot_of(const SizedCamera& camera, const py::object& extras, py::object& progress)
{
    Shot shot;
    shot.camera = camera;
    progress = py::none();
    if (extras.is_none()) return shot;
    const auto given = extras.cast<py::dict>();
    const auto has = [&](const char* name) {
        return given.contains(name) && !given[name].is_none();
    };
    if (has("region")) shot.region = region_of(given["region"]);
    if (has("lights")) shot.lights = given["lights"].cast<std::vector<Light>>();
    if (has("previous_world")) shot.previous = &given["previous_world"].cast<PosedWorld&>();
    if (has("previous_camera")) shot.previous_camera = given["previous_camera"].cast<SizedCamera>();
    if (has("progress")) progress = given["progress"];
    return shot;
}

/// The lights of a shot in the place of the world's, while it exists.
class Lighting {
  public:
    Lighting(World& world, const Shot& shot) : world_(world)
    {
        kept_ = world.lights;
        if (shot.lights) world.lights = *shot.lights;
        hang_lights(shot.camera.view.camera, world);
    }
    ~Lighting() { world_.lights = std::move(kept_); }
    Lighting(const Lighting&) = delete;
    Lighting& operator=(const Lighting&) = delete;

  private:
    World& world_;
    std::vector<Light> kept_;
};

/// Renders with the world's lock held in the way that it needs.
void render_shot(Renderer& renderer, PosedWorld& world, const Shot& shot, Settings settings,
    Frame& frame, const FrameControl& control)
{
    View view = shot.camera.view;
    if (shot.region) {
        const auto& [x, y, width, height] = *shot.region;
        view.region = {x, y, width, height};
    }
    std::shared_lock<std::shared_mutex> before;
    if (shot.previous && shot.previous != &world) before = std::shared_lock(shot.previous->use);
    if (shot.previous)
        settings.previous = {&shot.previous->world,
            shot.previous_camera ? shot.previous_camera->view.camera : view.camera};
    const bool change =
        needs_lights(settings) && (shot.lights || follows_camera(world.world.lights));
    if (change) {
        const std::unique_lock lock(world.use);
        const Lighting lighting(world.world, shot);
        renderer.render(world.world, view, settings, frame.film, control);
    } else {
        const std::shared_lock lock(world.use);
        renderer.render(world.world, view, settings, frame.film, control);
    }
    frame.stats = renderer.stats();
    frame.engine = name_of(renderer.engine().engine);
}

} // namespace

void PythonRenderer::render(PosedWorld& world, const SizedCamera& camera, const Settings& settings,
    const py::object& extras, Frame& frame)
{
    py::object progress;
    const Shot shot = shot_of(camera, extras, progress);
    Watch watch(progress);
    FrameControl control;
    control.progress = [&watch](double share) { watch(share); };
    const Unlocked unlocked;
    const std::lock_guard lock(turn_);
    render_shot(renderer_, world, shot, settings, frame, control);
}

std::vector<std::unique_ptr<Frame>> render_batch(PosedWorld& world,
    const std::vector<SizedCamera>& cameras, const Settings& settings,
    const std::optional<std::vector<Light>>& lights, const py::object& given_threads)
{
    const int threads = thread_count(given_threads);
    std::vector<std::unique_ptr<Frame>> frames(cameras.size());
    for (auto& frame : frames) frame = std::make_unique<Frame>();
    std::size_t workers =
        threads > 0 ? std::size_t(threads) : std::max(1u, std::thread::hardware_concurrency());
    workers = std::min(workers, std::max<std::size_t>(1, cameras.size()));
    const Unlocked unlocked;
    const std::shared_lock lock(world.use);
    const bool change = needs_lights(settings) && (lights || follows_camera(world.world.lights));
    std::atomic<std::size_t> next{0};
    std::stop_source stop;
    std::mutex failure_lock;
    std::exception_ptr failure;
    const auto fail = [&] {
        const std::lock_guard guard(failure_lock);
        if (!failure) failure = std::current_exception();
        stop.request_stop();
    };
    const auto work = [&] {
        try {
            Renderer renderer(1);
            World own; // with lights that follow each camera
            if (change) {
                own = world.world;
                if (lights) own.lights = *lights;
            }
            const FrameControl control{.stop = stop.get_token(), .progress = {}};
            for (std::size_t k; !stop.stop_requested() && (k = next++) < cameras.size();) {
                const View& view = cameras[k].view;
                if (change) hang_lights(view.camera, own);
                renderer.render(
                    change ? own : world.world, view, settings, frames[k]->film, control);
                frames[k]->stats = renderer.stats();
                frames[k]->engine = name_of(renderer.engine().engine);
            }
        } catch (...) {
            fail();
        }
    };
    std::vector<std::jthread> pool;
    for (std::size_t k = 0; k < workers; ++k) pool.emplace_back(work);
    // This thread listens for Ctrl-C meanwhile.
    while (next < cameras.size() + workers && !stop.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        try {
            const Locked locked;
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        } catch (...) {
            fail();
        }
    }
    pool.clear(); // waits for the frames in work
    if (failure) std::rethrow_exception(failure);
    return frames;
}

} // namespace firsthit::python
