// compare.h - compares items and shadows with other ray casters, and engines with each other.
#pragma once

#include <firsthit/film.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>
#include <firsthit/view.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace firsthit {

/// What items and shadows are compared with.
enum class Oracle {
    brute,  // every triangle for every pixel, with the exact predicate
    embree, // Embree 3, robust flag
};

/// Counts of pixels. agree + ties + ours_wrong + theirs_wrong = pixels. A pixel for which both are
/// wrong is counted in ours_wrong.
struct Comparison {
    std::uint64_t pixels = 0;       // pixels of the frame
    std::uint64_t agree = 0;        // both have the same item
    std::uint64_t ties = 0;         // different items at exactly the same depth
    std::uint64_t ours_wrong = 0;   // by exact arithmetic, ours is not the nearest hit of lowest id
    std::uint64_t theirs_wrong = 0; // by exact arithmetic, ours is right and theirs is not
};

/// Compares the items of one frame with those of another ray caster.
/// threads   0: one for each core
/// progress  called now and then, on one thread, with the share of the work that is done, 0 to 1
/// throws    DeviceError: the build has no Embree; ArgumentError as Renderer::render
Comparison compare(const World& world, const View& view, Oracle oracle, int threads = 0,
    const std::function<void(double)>& progress = {});

/// Counts of (hit, light) pairs, by whether the light reaches the hit. agree + ours_wrong +
/// theirs_wrong = pixels.
struct LitComparison {
    std::uint64_t pixels = 0;       // number of hits * number of lights
    std::uint64_t agree = 0;        // both have the same answer
    std::uint64_t ours_wrong = 0;   // brute force over all triangles contradicts our answer
    std::uint64_t theirs_wrong = 0; // brute force confirms our answer
};

/// Compares the exact shadows of one frame (Aov::lit) with those of another ray caster for the same
/// points. This includes the test which side of a surface a light is on, and the cones of spot
/// lights.
/// threads   0: one for each core
/// progress  as compare
/// throws    as compare; SceneError: an invalid light (position, direction or cone)
LitComparison compare_lit(const World& world, const View& view, Oracle oracle, int threads = 0,
    const std::function<void(double)>& progress = {});

/// How well an OpenGL engine agrees with the cpu engine. Items belong to the rays through the
/// centres of pixels. Pictures are compared by their displayed values: channels clamped to [0, 1]
/// and encoded as sRGB, in [0, 1] without rounding to 8 bits.
struct EngineComparison {
    std::uint64_t pixels = 0;       // pixels of the frame
    std::uint64_t missed = 0;       // the cpu engine sees a triangle, the other engine none
    std::uint64_t wrong = 0;        // the engine sees another triangle, which is not a tie
    std::uint64_t ties = 0;         // different triangles at exactly the same depth
    std::uint64_t interpolated = 0; // pixels that got their colour from the pixels around them
    double square_sum = 0;          // sum of the squared differences of all displayed values
    double largest_difference = 0;  // largest difference of a displayed value, 0 to 1
    /// square_sum of the gpu engine's picture if it uses the cpu engine's items and shadow maps.
    /// Empty for the hybrid engine, for several samples in a pixel, and for pictures that are made
    /// in sections.
    std::optional<double> square_sum_same_items;

    /// Peak signal to noise ratio in decibels: 10 log10(number of values / square_sum). +inf if the
    /// pictures are equal.
    double psnr_db() const;

    /// The same for square_sum_same_items; empty if that is empty.
    std::optional<double> psnr_same_items_db() const;
};

/// The comparison of all frames of a and b.
EngineComparison operator+(const EngineComparison& a, const EngineComparison& b);

/// Compares engines over several frames, and keeps programs and memory between them. Not
/// thread-safe.
class EngineComparer {
  public:
    /// threads  number of threads; 0: one for each core
    explicit EngineComparer(int threads = 0);
    ~EngineComparer();
    EngineComparer(const EngineComparer&) = delete;
    EngineComparer& operator=(const EngineComparer&) = delete;

    /// Renders the frame with settings.engine, which must be hybrid or gpu, and with the cpu
    /// engine, both with the same settings. Shadows::automatic means map for both. Ignores
    /// settings.color and settings.aovs.
    /// throws  ArgumentError: another engine, and as Renderer::render
    ///         DeviceError: there is no OpenGL, or it fails. The next frame makes a new context
    EngineComparison compare(const World& world, const View& view, const Settings& settings);

    /// The engine's picture of the last frame, with the plane `item`.
    const Film& engine_film() const;

    /// The cpu engine's picture of the last frame, with the plane `item`.
    const Film& cpu_film() const;

    /// OpenGL's renderer and version in the last frame.
    const std::string& device() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Compares engines for a single frame: see EngineComparer::compare.
EngineComparison compare_engines(
    const World& world, const View& view, const Settings& settings, int threads = 0);

} // namespace firsthit
