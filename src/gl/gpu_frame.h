// gpu_frame.h - the gpu engine: makes a picture of a posed world with OpenGL alone.
//
// source  Robert and Schoepke 2006, section 4.2
#pragma once

#include "base/stopwatch.h"
#include "exact/pencil.h"
#include "frame/frame_context.h"
#include "gl/device/context.h"
#include "gl/items/gpu_items.h"
#include "gl/shadow/gpu_shadows.h"
#include "gl/scene/environment_buffer.h"
#include "gl/scene/material_buffers.h"
#include "gl/sample_passes.h"
#include "gl/scene/scene_buffers.h"
#include "gl/scene/scene_textures.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>

#include <vector>

namespace firsthit::gl {

/// Where the engine gets items and shadow maps from.
struct GpuSources {
    GpuItems& items; // must be exact for Multisample::exact, because items are then not tested
    const ShadowMaps* maps = nullptr; // maps of the cpu engine; null: OpenGL draws them
};

struct GpuOptions {
    bool count_invocations = false; // see SamplePasses
    int section_side = 4096;        // largest side of a section, samples: takes 900 MB
};

/// The engine's buffers, textures and programs. They are kept from frame to frame, and once sizes
/// have settled nothing more is created. The context must be current when this is made, used and
/// deleted.
class GpuFrame {
  public:
    /// throws  DeviceError: see link_program
    explicit GpuFrame(const Context& context, const GpuOptions& options = {});

    /// Renders the view's region into the film and adds to the statistics. `settings` and the
    /// frame's view must have passed render/check_settings.h. Shadows::automatic means map.
    ///
    /// limits  a picture with a side of more than options.section_side samples is made in sections.
    ///         Neighbours of a sample, for item repair and filling holes, are taken from its
    ///         section only
    /// throws  DeviceError: no memory, a scene or maps beyond the driver's limits, a lost context
    ///         Cancelled: between two passes
    void render(const FrameContext& context, const Settings& settings, const GpuSources& sources,
        Stats& stats);

    SamplePasses& passes() { return passes_; }
    const GpuShadows& shadows() const { return shadows_; }

  private:
    struct Job;
    struct Section;
    struct Pass;
    void render_pass(const Job& job, const Pass& pass);
    void render_section(const Job& job, const Section& section);
    void find_shadows(const Job& job, const Rays& rays, bool stored);
    void read_planes(const Job& job, const Section& section, bool stored);
    double stage_ms();
    /// Bytes of the scene that were uploaded so far.
    std::uint64_t uploaded_bytes() const
    {
        return scene_.uploaded_bytes() + materials_.uploaded_bytes() +
               environment_.uploaded_bytes();
    }

    const Context& context_;
    GpuOptions options_;
    SceneBuffers scene_;
    SceneTextures scene_textures_;
    MaterialBuffers materials_;
    EnvironmentBuffer environment_;
    GpuShadows shadows_;
    SamplePasses passes_;
    std::vector<LightBounds> bounds_;
    std::vector<float> plane_; // visibility of one light
    Stopwatch watch_;
};

} // namespace firsthit::gl
