// stats.h - times and counts of a frame.
#pragma once

#include <cstdint>

namespace firsthit {

/// Times, in milliseconds, and counts of a frame. The stages raster, resolve and shade run tile by
/// tile on all threads: their times are sums over all threads, divided by the number of threads.
struct Stats {
    double pose_ms = 0;    // posing the scene
    double setup_ms = 0;   // projecting vertices, sorting triangles into tiles
    double raster_ms = 0;  // finding the triangle that each sample sees
    double resolve_ms = 0; // finding the exact hits
    double shadow_ms = 0;  // finding the lights that reach the hits; for exact shadows, including:
    double shadow_collect_ms = 0; // moving the hits into the space of each light
    double shadow_sort_ms = 0;    // projecting vertices, sorting points and triangles into cells
    double shadow_test_ms = 0;    // testing triangles against points
    double sky_ms = 0;            // finding which hits see which directions of the sky
    double shade_ms = 0;          // computing colours and planes
    double mark_ms = 0;           // Settings::adaptive: finding the pixels that may hold an edge
    double fine_ms = 0;          // all stages of their samples; these are counted in the stages too
    double draw_ms = 0;          // hybrid: posing vertices and sending triangles to OpenGL
    double transfer_ms = 0;      // hybrid: from then until all items are in host memory
    double wait_ms = 0;          // hybrid: how long the CPU waited for items
    double write_ms = 0;         // writing files; render() leaves it 0, the program fills it in
    double total_ms = 0;         // the whole frame, wall clock time
    std::uint64_t vertices = 0;  // of the scene
    std::uint64_t triangles = 0; // of the scene
    std::uint64_t in_view = 0;   // triangles whose bounding box contains a sample
    std::uint64_t tile_entries = 0;      // (triangle, tile) pairs
    std::uint64_t uncertain_lanes = 0;   // coverage tests that the float filter could not decide
    std::uint64_t ambiguous_lanes = 0;   // depth comparisons that the float filter could not decide
    std::uint64_t exact_calls = 0;       // decisions by expansion arithmetic
    std::uint64_t hits = 0;              // samples with an item
    std::uint64_t uncertain_samples = 0; // Multisample::exact: samples that the CPU decided
    std::uint64_t missed = 0;            // OpenGL engines: samples whose triangle was not found
    std::uint64_t interpolated = 0;      // pixels that got their colour from the pixels around them
    std::uint64_t fine_pixels = 0;       // Settings::adaptive: pixels that got N x N samples
    std::uint64_t shadow_points = 0; // exact shadows: shadow rays, one for each (hit, light) pair
    std::uint64_t shadow_triangles = 0; // exact shadows: triangle setups, for each light and cell
    std::uint64_t shadow_pairs = 0;     // exact shadows: tests of a triangle against a point
    std::uint64_t shadow_uncertain = 0; // those that the float filter could not decide
    std::uint64_t sky_points = 0;       // shadow rays towards the sky, as shadow_points
    std::uint64_t map_updates = 0;      // shadow maps that were made
    std::uint64_t uploaded_bytes = 0;   // bytes of the scene that were uploaded to OpenGL
};

} // namespace firsthit
