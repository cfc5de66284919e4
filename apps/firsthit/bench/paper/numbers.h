// numbers.h - what Robert and Schoepke 2006 measured, and which of our frames stand beside it.
#pragma once

#include <array>
#include <span>

namespace firsthit::cli::bench {

inline constexpr const char* kPaper =
    "Robert, Schoepke 2006, Interactive Ray Tracing Using Hardware Accelerated Image-Space Methods";
inline constexpr const char* kPaperMachine =
    "AMD Athlon64 3500+, GeForce 7800GT, PCI Express 16x, Windows XP, one thread without SIMD";

/// Robots, bunny, torus: the order of the paper's columns.
inline constexpr std::size_t kPaperScenes = 3;
using PaperFps = std::array<double, kPaperScenes>;

/// Table 1.
inline constexpr std::array<const char*, kPaperScenes> kPaperNames = {"Robots", "Bunny", "Torus"};
inline constexpr std::array<int, kPaperScenes> kPaperTriangles = {71708, 69451, 1024};

/// A row of tables 2 to 4: frames per second.
struct PaperRow {
    const char* name;
    const char* way;         // of ways.h
    PaperFps paper;          // 0: the paper has no such row
    bool items_only = false; // only the item buffer is timed
};

// One frame of ours may stand beside several of the paper's: its tables 2, 3 and 4 give three numbers for
// the same frame, the CPU's without shadows and multisampling (robots: 2.9, 3.2 and 2.6).
inline constexpr PaperRow kTable2[] = {
    {"synchronous: hybrid", "hybrid sync", {2.8, 6.1, 4.4}},
    {"asynchronous: hybrid", "hybrid", {2.9, 6.2, 4.5}},
    {"item buffer alone: OpenGL", "gpu", {73, 71, 850}, true},
    {"item buffer alone: cpu", "cpu", {}, true},
};
inline constexpr PaperRow kTable3[] = {
    {"CPU, no shadows: hybrid", "hybrid", {3.2, 6.1, 4.5}},
    {"CPU, no shadows: cpu", "cpu", {3.2, 6.1, 4.5}},
    {"CPU, shadowed: hybrid, maps", "hybrid maps", {1.4, 5.5, 3.8}},
    {"CPU, shadowed: cpu, maps", "cpu maps", {1.4, 5.5, 3.8}},
    {"CPU, shadowed: cpu, exact", "cpu exact", {1.4, 5.5, 3.8}},
    {"GPU, no shadows: gpu", "gpu", {19, 36, 117}},
    {"GPU, shadowed: gpu, maps", "gpu maps", {19, 36, 106}},
};
inline constexpr PaperRow kTable4[] = {
    {"CPU, interleaved: hybrid", "hybrid interleaved", {3.4, 5.8, 5.0}},
    {"CPU, no multisampling: hybrid", "hybrid", {2.6, 4.9, 4.5}},
    {"CPU, lazy 3x3: hybrid", "hybrid lazy3", {2.5, 3.9, 4.3}},
    {"CPU, lazy 5x5: hybrid", "hybrid lazy5", {2.4, 2.5, 4.1}},
    {"CPU, 3x3: hybrid", "hybrid full3", {1.6, 2.2, 2.3}},
    {"CPU, 5x5: hybrid", "hybrid full5", {1.2, 1.2, 1.4}},
    {"GPU, no multisampling: gpu", "gpu", {19, 36, 117}},
    {"exact, nothing to repair: cpu", "cpu", {}},
    {"exact, interleaved: cpu", "cpu interleaved", {}},
};

struct PaperTable {
    int number;
    const char* title;
    std::span<const PaperRow> rows;
    const char* note;
};
inline constexpr PaperTable kTables[] = {
    {2, "Table 2: readback; no shadows, no multisampling; frames per second", kTable2,
        "Item buffer alone: of OpenGL (gpu engine) the upload of what has changed and the drawing, "
        "without "
        "readback, as in the paper; of the cpu engine vertices to the view, triangles to tiles, "
        "raster."},
    {3, "Table 3: engines with and without shadows, no multisampling; frames per second", kTable3,
        "What the paper calls CPU is our hybrid engine. The cpu engine's rows stand beside the "
        "same numbers; "
        "exact shadows are what the paper's shadow maps approximate."},
    {4, "Table 4: multisampling, no shadows; frames per second", kTable4,
        "The paper has three numbers for one frame, the CPU's without shadows and multisampling: "
        "in its "
        "tables 2, 3 and 4 the robots have 2.9, 3.2 and 2.6. Lazy: the neighbours' triangles are "
        "tried where "
        "the pixel's own is missed; else at every pixel. The cpu engine's items are those that are "
        "hit, so "
        "it has nothing to try."},
};

/// How many times faster our cpu engine makes a frame than OpenGL does: what the paper does not ask.
struct PaperRatio {
    const char* name;
    const char* way;
    const char* slower;
};
inline constexpr PaperRatio kRatios[] = {
    {"no shadows: cpu to gpu", "cpu", "gpu"},
    {"maps: cpu to gpu", "cpu maps", "gpu maps"},
    {"exact shadows to gpu's maps", "cpu exact", "gpu maps"},
    {"no shadows: cpu to hybrid", "cpu", "hybrid"},
    {"maps: cpu to hybrid", "cpu maps", "hybrid maps"},
};

/// Figure 9 is a curve without numbers; its mean is table 4's row without multisampling.
inline constexpr double kFigure9Fps = 2.6;

} // namespace firsthit::cli::bench
