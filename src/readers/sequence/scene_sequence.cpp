// scene_sequence.cpp - numbered scene files as one animation.
#include <firsthit/sequence.h>

#include "readers/image/picture_cache.h"
#include "readers/read_scene.h"
#include "readers/sequence/flatten.h"
#include "readers/sequence/frame_cache.h"
#include "scene/model/borrow.h"
#include "scene/model/default_light.h"

#include <firsthit/error.h>
#include <firsthit/file_pattern.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace firsthit {
namespace {

/// A time this near to a frame's begin, in units of 1 / fps, is that begin: times that were computed in
/// another way are off by rounding, and a change of topology must not come a frame too late.
constexpr double kSameTime = 1e-6;

/// Numbers that have no file. Nothing where there are none.
std::vector<std::string> gap_warnings(const FilePattern& pattern, const std::vector<int>& numbers)
{
    const std::size_t span = static_cast<std::size_t>(numbers.back() - numbers.front()) + 1;
    const std::size_t missing = span - numbers.size();
    if (missing == 0) return {};
    const auto gap =
        std::adjacent_find(numbers.begin(), numbers.end(), [](int a, int b) { return b != a + 1; });
    return {
        fmt::format("{}: {} of the numbers from {} to {} {} no file (the first is {}): the frames "
                    "on both sides of a gap follow each other",
            pattern.text(), missing, numbers.front(), numbers.back(), missing == 1 ? "has" : "have",
            pattern.name(*gap + 1))};
}

} // namespace

bool is_sequence_name(const std::string& name)
{
    if (name.find('%') == std::string::npos || std::string_view(name).starts_with("builtin:"))
        return false;
    std::error_code error;
    return !std::filesystem::exists(name, error);
}

struct SceneSequence::Impl {
    Impl(const std::string& scene_name, SequenceSettings chosen);

    /// Where a time is.
    struct Place {
        std::size_t frame = 0; // the last one that has begun
        bool between = false;  // after its begin, and there is a next one
    };

    SequenceFrame read(std::size_t number);
    Place place_of(double time_s) const;
    double time_s(std::size_t number) const
    {
        return double(numbers[number] - numbers.front()) / settings.fps;
    }
    void read_ahead(std::size_t number);
    std::shared_ptr<const Scene> scene_at(double time_s);
    void keep_topology(std::size_t number, const FrameCache::Frame& frame);
    std::shared_ptr<const Topology> topology_of_frame(std::size_t number);
    bool same_triangles(double a_s, double b_s);

    std::string name;
    SequenceSettings settings;
    std::optional<FilePattern> pattern; // nothing: a single scene
    std::vector<int> numbers;           // of the files, ascending
    std::vector<std::string> warnings;
    std::shared_ptr<const Scene> single; // where there is no pattern
    std::vector<std::string> files;      // of all frames
    std::vector<Light> lights;           // of frames that have none

    std::mutex change;               // settings.change is called by one thread at a time
    std::mutex use;                  // of all that follows
    std::ptrdiff_t step = 0;         // from the frame before last to the last one; 0: unknown
    std::optional<std::size_t> last; // the last frame that a time was in
    std::size_t pair = 0;            // the frame where `between` begins
    std::shared_ptr<const Scene> between;
    std::vector<std::pair<std::size_t, std::shared_ptr<const Topology>>>
        topologies; // of the last two frames that times were in, by number
    PictureCache pictures;
    FrameCache cache; // last: its thread uses what is above
};

SceneSequence::Impl::Impl(const std::string& scene_name, SequenceSettings chosen)
    : name(scene_name),
      settings(std::move(chosen)),
      cache([this](std::size_t number) { return read(number); })
{
    if (!(SequenceSettings::kMinFps <= settings.fps && settings.fps <= SequenceSettings::kMaxFps))
        throw ArgumentError(fmt::format("{}: {} frames a second: accepted are {} to {}", name,
            settings.fps, SequenceSettings::kMinFps, SequenceSettings::kMaxFps));
    if (!is_sequence_name(name)) {
        Scene scene = load_scene(name, settings.load);
        if (settings.change) settings.change(scene);
        numbers = {0};
        single = std::make_shared<const Scene>(std::move(scene));
        return;
    }
    pattern.emplace(name);
    numbers = pattern->existing();
    if (numbers.empty())
        throw FileError(fmt::format(
            "{}: there is no file of that pattern, such as {}", name, pattern->name(1)));
    if (numbers.size() > kMaxFiles)
        throw FileError(
            fmt::format("{}: {} files, at most {} are accepted", name, numbers.size(), kMaxFiles));
    warnings = gap_warnings(*pattern, numbers);
    if (settings.load.strict && !warnings.empty()) throw FileError(warnings.front());
    for (const int number : numbers) files.push_back(pattern->name(number));
    (void)cache.frame(0);
}

/// Called by one thread at first, for the first frame; then by the caller's and the one that reads ahead.
SequenceFrame SceneSequence::Impl::read(std::size_t number)
{
    const PictureCache::Use use_pictures(pictures);
    std::vector<glm::uvec3> corners;
    Scene scene = read_scene(files[number], settings.load, &corners);
    flatten(scene);
    if (number == 0 && lights.empty()) {
        if (scene.lights.empty()) {
            add_default_light(scene);
            lights = scene.lights;
        }
    } else if (scene.lights.empty()) {
        scene.lights = lights;
    }
    const double last_s = time_s(numbers.size() - 1);
    scene.clips = {
        Clip{.name = "sequence", .end_s = last_s, .frames = numbers.back() - numbers.front() + 1}};

    // The files of all frames, then what else this one was read from.
    std::vector<std::string> others = std::move(scene.files);
    scene.files = files;
    for (std::string& other : others)
        if (other != files[number]) scene.files.push_back(std::move(other));
    if (settings.change) {
        const std::lock_guard one_at_a_time(change);
        settings.change(scene);
    }
    SequenceFrame frame;
    frame.topology = std::make_shared<const Topology>(topology_of(scene, std::move(corners)));
    frame.scene = std::make_shared<const Scene>(std::move(scene));
    return frame;
}

SceneSequence::Impl::Place SceneSequence::Impl::place_of(double time_s) const
{
    const double number = time_s * settings.fps + double(numbers.front());
    const auto after = std::upper_bound(numbers.begin(), numbers.end(), number + kSameTime,
        [](double x, int frame) { return x < double(frame); });
    if (after == numbers.begin()) return {0, false};
    const auto frame = static_cast<std::size_t>(after - numbers.begin()) - 1;
    return {frame, after != numbers.end() && number - double(numbers[frame]) > kSameTime};
}

/// Reads what is likely to be needed next: as many frames further as the last time, and that one's
/// neighbour. Nothing before two frames were asked for: a single picture needs no more.
void SceneSequence::Impl::read_ahead(std::size_t number)
{
    if (last && *last != number) step = std::ptrdiff_t(number) - std::ptrdiff_t(*last);
    last = number;
    if (step == 0) return;
    for (const std::ptrdiff_t next :
        {std::ptrdiff_t(number) + step, std::ptrdiff_t(number) + step + 1}) {
        if (next < 0 || next >= std::ptrdiff_t(numbers.size())) continue;
        if (cache.has(std::size_t(next))) continue;
        cache.read_ahead(std::size_t(next));
        return;
    }
}

std::shared_ptr<const Scene> SceneSequence::Impl::scene_at(double time_s)
{
    const std::lock_guard one_at_a_time(use);
    const Place place = place_of(time_s);
    if (!place.between) {
        if (place.frame != pair && place.frame != pair + 1) between.reset(); // its frames too
        const FrameCache::Frame frame = cache.frame(place.frame);
        keep_topology(place.frame, frame);
        read_ahead(place.frame);
        return frame->scene;
    }
    if (between && pair == place.frame) {
        read_ahead(place.frame);
        return between;
    }
    between.reset(); // let go before more is read
    if (!cache.has(place.frame)) cache.read_ahead(place.frame + 1);
    const FrameCache::Frame a = cache.frame(place.frame);
    const FrameCache::Frame b = cache.frame(place.frame + 1);
    keep_topology(place.frame, a);
    read_ahead(place.frame);
    const std::optional<CornerMap> map = match(*a->topology, *b->topology);
    between = map ? std::make_shared<const Scene>(scene_between(
                        *a, *b, *map, this->time_s(place.frame), this->time_s(place.frame + 1)))
                  : a->scene;
    pair = place.frame;
    return between;
}

void SceneSequence::Impl::keep_topology(std::size_t number, const FrameCache::Frame& frame)
{
    for (const auto& [known, topology] : topologies)
        if (known == number) return;
    if (topologies.size() == 2) topologies.erase(topologies.begin());
    topologies.emplace_back(number, frame->topology);
}

/// Reads the frame again only where it is not one of the last two.
std::shared_ptr<const Topology> SceneSequence::Impl::topology_of_frame(std::size_t number)
{
    for (const auto& [known, topology] : topologies)
        if (known == number) return topology;
    return cache.frame(number)->topology;
}

bool SceneSequence::Impl::same_triangles(double a_s, double b_s)
{
    const std::lock_guard one_at_a_time(use);
    const std::size_t a = place_of(a_s).frame, b = place_of(b_s).frame;
    if (a == b) return true;
    const std::optional<CornerMap> map = match(*topology_of_frame(a), *topology_of_frame(b));
    return map && map->corner.empty();
}

SceneSequence::SceneSequence(const std::string& name, const SequenceSettings& settings)
    : impl_(std::make_unique<Impl>(name, settings))
{
}
SceneSequence::~SceneSequence() = default;
SceneSequence::SceneSequence(SceneSequence&&) noexcept = default;
SceneSequence& SceneSequence::operator=(SceneSequence&&) noexcept = default;

bool SceneSequence::is_numbered() const
{
    return impl_->pattern.has_value();
}

std::shared_ptr<const Scene> SceneSequence::scene_at(double time_s)
{
    if (!std::isfinite(time_s))
        throw ArgumentError(impl_->name + ": the time of a scene must be a finite number");
    return impl_->single ? impl_->single : impl_->scene_at(time_s);
}

bool SceneSequence::same_triangles(double a_s, double b_s)
{
    if (!std::isfinite(a_s) || !std::isfinite(b_s))
        throw ArgumentError(impl_->name + ": the time of a scene must be a finite number");
    return impl_->single || impl_->same_triangles(a_s, b_s);
}

std::shared_ptr<const Scene> SceneSequence::frame(std::size_t number)
{
    if (number >= frames())
        throw ArgumentError(
            fmt::format("{}: there is no frame {} ({} exist)", impl_->name, number, frames()));
    if (impl_->single) return impl_->single;
    const std::lock_guard one_at_a_time(impl_->use);
    return impl_->cache.frame(number)->scene;
}

std::size_t SceneSequence::frames() const
{
    return impl_->numbers.size();
}

double SceneSequence::time_s(std::size_t number) const
{
    return impl_->time_s(std::min(number, frames() - 1));
}

double SceneSequence::end_s() const
{
    return impl_->single ? impl_->single->end_s() : time_s(frames() - 1);
}

std::string SceneSequence::file(std::size_t number) const
{
    return impl_->single ? impl_->name : impl_->files[std::min(number, frames() - 1)];
}

double SceneSequence::fps() const
{
    return impl_->settings.fps;
}

const std::vector<std::string>& SceneSequence::warnings() const
{
    return impl_->warnings;
}

SequenceSummary SceneSequence::summary()
{
    const std::lock_guard one_at_a_time(impl_->use);
    SequenceSummary sum;
    std::shared_ptr<const Topology> topology; // of the frame before
    for (std::size_t k = 0; k < frames(); ++k) {
        FrameCache::Frame frame;
        if (!impl_->single) {
            frame = impl_->cache.frame(k);
            if (k + 1 < frames()) impl_->cache.read_ahead(k + 1);
        }
        const Scene& scene = frame ? *frame->scene : *impl_->single;
        World world;
        pose(borrow(scene), scene.begin_s(), world);
        const std::array<glm::vec3, 2> box = firsthit::bounds(world);
        const auto add = [k](std::array<std::size_t, 2>& range, std::size_t count) {
            range = {k == 0 ? count : std::min(range[0], count), std::max(range[1], count)};
        };
        add(sum.triangles, scene.triangle_count());
        add(sum.vertices, scene.vertex_count());
        sum.bounds = k == 0 ? box
                            : std::array<glm::vec3, 2>{
                                  glm::min(sum.bounds[0], box[0]), glm::max(sum.bounds[1], box[1])};
        if (!frame) break;
        if (k > 0 && !match(*topology, *frame->topology)) sum.new_topology.push_back(k);
        topology = frame->topology;
    }
    return sum;
}

} // namespace firsthit
