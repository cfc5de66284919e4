// gpu_frame.h - the gpu engine: a picture from a posed world, all by OpenGL.
//
// source  Robert and Schoepke 2006, section 4.2
#pragma once

#include "base/stopwatch.h"
#include "exact/pencil.h"
#include "frame/frame_context.h"
#include "gl/device/context.h"
#include "gl/items/gpu_items.h"
#include "gl/shadow/gpu_shadows.h"
#include "gl/scene/material_buffers.h"
#include "gl/sample_passes.h"
#include "gl/scene/scene_buffers.h"
#include "gl/scene/scene_textures.h"

#include <firsthit/film.h>
#include <firsthit/settings.h>
#include <firsthit/stats.h>

#include <vector>

namespace firsthit::gl {

/// What the engine is given.
struct GpuSources {
    GpuItems& items; // with Multisample::exact they have to be right: no ray is tested
    const ShadowMaps* maps = nullptr; // of the cpu engine; null: they are drawn
};

struct GpuOptions {
    bool count_invocations = false; // see SamplePasses
    int part_side = 4096;           // samples on the side of a part, at most: 900 MB
};

/// Buffers, textures and programs of the engine, kept from frame to frame: nothing is created once
/// sizes have settled. To be made, used and deleted with its context current.
class GpuFrame {
  public:
    /// throws  DeviceError: see link_program
    explicit GpuFrame(const Context& context, const GpuOptions& options = {});

    /// Renders the view's region into the film and adds to the statistics. `settings` and the
    /// frame's view are checked (render/check_settings.h). Shadows::automatic is map.
    ///
    /// limits  pictures with more samples than options.part_side on a side are made in parts; each
    ///         part looks at neighbours and fills holes inside itself
    /// throws  DeviceError: no memory, a scene or maps beyond the driver's limits, a lost context
    ///         Cancelled: between two passes
    void render(const FrameContext& context, const Settings& settings, const GpuSources& sources,
        Stats& stats);

    SamplePasses& passes() { return passes_; }
    const GpuShadows& shadows() const { return shadows_; }

  private:
    struct Job;
    struct Part;
    struct Pass;
    void render_pass(const Job& job, const Pass& pass);
    void render_part(const Job& job, const Part& part);
    void find_shadows(const Job& job, const Rays& rays, bool stored);
    void read_planes(const Job& job, const Part& part, bool stored);
    double stage_ms();
    /// Of the scene so far.
    std::uint64_t uploaded_bytes() const
    {
        return scene_.uploaded_bytes() + materials_.uploaded_bytes();
    }

    const Context& context_;
    GpuOptions options_;
    SceneBuffers scene_;
    SceneTextures scene_textures_;
    MaterialBuffers materials_;
    GpuShadows shadows_;
    SamplePasses passes_;
    std::vector<LightBounds> bounds_;
    std::vector<float> plane_; // of one light
    Stopwatch watch_;
};

} // namespace firsthit::gl
