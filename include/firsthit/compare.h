// compare.h - holds items and shadows against other ray casters, and engines against each other.
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

/// agree + ties + ours_wrong + theirs_wrong = pixels (both_wrong is counted in ours_wrong).
struct Comparison {
    std::uint64_t pixels = 0;       // of the frame
    std::uint64_t agree = 0;        // the same item
    std::uint64_t ties = 0;         // different items at exactly the same depth
    std::uint64_t ours_wrong = 0;   // exact arithmetic says: ours is not the nearest hit, lowest id
    std::uint64_t theirs_wrong = 0; // exact arithmetic says: ours is right, theirs is not
};

/// Compares the items of one frame with those of another caster.
/// progress  called on one thread now and then with the share of the casting that is done
/// throws    DeviceError where the build has no Embree; ArgumentError as Renderer::render
Comparison compare(const World& world, const View& view, Oracle oracle, int threads = 0,
    const std::function<void(double)>& progress = {});

/// Of all hits and all lights: does the light reach the hit? agree + ours_wrong + theirs_wrong =
/// pixels.
struct LitComparison {
    std::uint64_t pixels = 0;       // hits times lights
    std::uint64_t agree = 0;        // the same answer
    std::uint64_t ours_wrong = 0;   // the plain loop over all triangles says otherwise
    std::uint64_t theirs_wrong = 0; // it says that ours is right
};

/// Compares the exact shadows of one frame (Aov::lit) with those of another caster for the same
/// points; which side of a surface a light is on, and cones, are compared as well.
/// progress  as compare
/// throws    as compare; SceneError: a light that is no sound one
LitComparison compare_lit(const World& world, const View& view, Oracle oracle, int threads = 0,
    const std::function<void(double)>& progress = {});

/// How far an engine on OpenGL agrees with the cpu engine. Items are of the rays through the pixels'
/// centres; pictures are compared by their displayed values: the channels, clamped to [0, 1] and
/// sRGB-encoded, without rounding to codes.
struct EngineComparison {
    std::uint64_t pixels = 0;       // of the frame
    std::uint64_t missed = 0;       // the cpu sees a triangle, the engine none
    std::uint64_t wrong = 0;        // the engine sees a triangle that is not the cpu's and no tie
    std::uint64_t ties = 0;         // different triangles, both hit at exactly the same depth
    std::uint64_t interpolated = 0; // pixels that got the colours around them
    double square_sum = 0;          // of the differences of all displayed values
    double largest_difference = 0;  // of a displayed value
    /// square_sum of the gpu engine's picture when it is lent the cpu engine's items and shadow maps.
    /// Nothing of the hybrid engine, of several samples, and of pictures that are made in parts.
    std::optional<double> square_sum_same_items;

    /// Peak signal to noise ratio, decibels: 10 log10(values / square_sum). Infinite where the
    /// pictures are equal.
    double psnr_db() const;

    /// The same of square_sum_same_items; nothing where that is nothing.
    std::optional<double> psnr_same_items_db() const;
};

/// Of the frames of both.
EngineComparison operator+(const EngineComparison& a, const EngineComparison& b);

/// Compares engines over several frames: programs and memory are kept. One frame at a time.
class EngineComparer {
  public:
    /// threads  0: one for each core
    explicit EngineComparer(int threads = 0);
    ~EngineComparer();
    EngineComparer(const EngineComparer&) = delete;
    EngineComparer& operator=(const EngineComparer&) = delete;

    /// Renders the frame by settings.engine, hybrid or gpu, and by the cpu engine with the same
    /// settings. Shadows::automatic is map for both. settings.color and .aovs are not looked at.
    /// throws  ArgumentError: another engine, and as Renderer::render
    ///         DeviceError: no OpenGL, or it fails; the next frame starts anew
    EngineComparison compare(const World& world, const View& view, const Settings& settings);

    /// The engine's picture of the last frame, with the plane `item`.
    const Film& engine_film() const;

    /// The cpu engine's picture of the last frame, with the plane `item`.
    const Film& cpu_film() const;

    /// Of the last frame: OpenGL's renderer and version.
    const std::string& device() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The same for a single frame.
EngineComparison compare_engines(
    const World& world, const View& view, const Settings& settings, int threads = 0);

} // namespace firsthit
