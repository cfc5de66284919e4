// stats.h - where a frame's time went, and what it counted.
#pragma once

#include <cstdint>

namespace firsthit {

/// Where a frame's time went and what it counted. Milliseconds. Raster, resolve and shade run tile
/// by tile on all threads: their sum over the threads, divided by the number of threads.
struct Stats {
    double pose_ms = 0;           // scene to world
    double setup_ms = 0;          // vertices to the view, triangles to tiles
    double raster_ms = 0;         // which triangle does each sample see?
    double resolve_ms = 0;        // where exactly is it hit?
    double shadow_ms = 0;         // which lights reach what is seen; of exact shadows the parts:
    double shadow_collect_ms = 0; // hits to points in the lights' spaces
    double shadow_sort_ms = 0;    // vertices to the lights' spaces, points and triangles into cells
    double shadow_test_ms = 0;    // triangles over points
    double shade_ms = 0;          // colour and planes
    double draw_ms = 0;           // hybrid: vertices posed and triangles handed to OpenGL
    double transfer_ms = 0;       // hybrid: from there until the last item is in host memory
    double wait_ms = 0;           // hybrid: how long the rays waited for items, of the two above
    double write_ms = 0;          // filled in by who writes
    double total_ms = 0;          // the whole frame, wall clock
    std::uint64_t vertices = 0;   // of the scene
    std::uint64_t triangles = 0;  // of the scene
    std::uint64_t in_view = 0;    // triangles whose box holds a sample
    std::uint64_t tile_entries = 0;      // (triangle, tile) pairs
    std::uint64_t uncertain_lanes = 0;   // coverage that the float filter left open
    std::uint64_t ambiguous_lanes = 0;   // depth order that the float filter left open
    std::uint64_t exact_calls = 0;       // answered by expansion arithmetic
    std::uint64_t hits = 0;              // samples with an item
    std::uint64_t uncertain_samples = 0; // Multisample::exact: decided on the CPU
    std::uint64_t missed = 0;            // samples whose triangle is not found (OpenGL's items)
    std::uint64_t interpolated = 0;      // pixels that got the colours around them
    std::uint64_t shadow_points = 0;     // exact: (hit, light) pairs that a shadow ray decides
    std::uint64_t shadow_triangles = 0;  // triangles set up, once for each light and cell of points
    std::uint64_t shadow_pairs = 0;      // tests of a triangle against a point
    std::uint64_t shadow_uncertain = 0;  // of these, left open by the float filter
    std::uint64_t map_updates = 0;       // shadow maps made anew
    std::uint64_t uploaded_bytes = 0;    // of the scene to OpenGL: what is new in this frame
};

} // namespace firsthit
