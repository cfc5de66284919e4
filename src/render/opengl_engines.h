// opengl_engines.h - the hybrid and the gpu engine, and their OpenGL context.
#pragma once

#include "cpu/frame.h"
#include "frame/frame_context.h"
#include "gl/items/certified_gpu_items.h"
#include "gl/device/context.h"
#include "gl/items/drawn_items.h"
#include "gl/items/given_items.h"
#include "gl/gpu_frame.h"
#include "gl/items/hybrid_items.h"
#include "gl/shadow/hybrid_maps.h"

#include <firsthit/settings.h>
#include <firsthit/stats.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace firsthit {

/// An OpenGL context and the engines on it. Each engine is made when it is first needed.
class OpenGlEngines {
  public:
    /// throws  DeviceError: no context
    OpenGlEngines() = default;
    ~OpenGlEngines();

    bool is_hardware() const { return context_.is_hardware(); }
    /// OpenGL's renderer and version.
    std::string device() const;

    /// Renders with the hybrid engine: the cpu engine's frame (cpu/frame.h) with items and shadow
    /// maps that OpenGL draws.
    void render_hybrid(
        const FrameContext& frame, const Settings& settings, FrameMemory& memory, Stats& stats);

    /// Renders with the gpu engine (gl/gpu_frame.h).
    void render_gpu(const FrameContext& frame, const Settings& settings, Stats& stats);

    /// The same with items and maps of the cpu engine. The picture must be a single section: its
    /// sides have at most gl::GpuOptions::section_side samples.
    /// items  (height, width) items of the view's region
    /// maps   null: OpenGL draws them
    void render_gpu_with(std::span<const std::uint32_t> items, const ShadowMaps* maps,
        const FrameContext& frame, const Settings& settings, Stats& stats);

  private:
    /// The members make the context current themselves. `items` is destroyed first, because after a
    /// cancelled frame it waits for the thread that still draws.
    struct Hybrid {
        explicit Hybrid(const gl::Context& context, gl::SceneBuffers& scene)
            : maps(context, scene),
              items(context, scene)
        {
            maps.set_items(items);
        }
        gl::HybridMaps maps;
        gl::HybridItems items;
    };

    gl::Context context_;
    std::optional<gl::SceneBuffers> scene_; // of the hybrid engine
    std::optional<Hybrid> hybrid_;
    std::optional<gl::GpuFrame> gpu_;
    std::optional<gl::DrawnItems> drawn_items_;
    std::optional<gl::CertifiedGpuItems> certified_items_;
    std::optional<gl::GivenItems> given_items_;
};

} // namespace firsthit
