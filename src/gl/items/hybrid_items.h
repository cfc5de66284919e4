// hybrid_items.h - items drawn by OpenGL, for the rays of the CPU.
#pragma once

#include "gl/items/certified_items.h"
#include "gl/items/item_pass.h"
#include "gl/items/item_readback.h"
#include "gl/device/job_thread.h"
#include "gl/scene/scene_buffers.h"
#include "visibility/item_source.h"

#include <firsthit/settings.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>

namespace firsthit::gl {

/// Where a frame's time on OpenGL went. Milliseconds, summed over the frame's parts.
struct HybridTimes {
    double draw_ms = 0;          // vertices posed, triangles sent to the driver
    double transfer_ms = 0;      // from there to the last item in host memory: raster and transfer
    double waiting_ms = 0;       // how long of all this the rays had to wait
    std::uint64_t uncertain = 0; // samples that the CPU decided
};

/// The item source of the hybrid engine: draws the part's items, reads them back and repairs tile
/// by tile on the CPU (hits/item_repair.h).
///
/// sync    everything is done by the caller's thread before start() returns.
/// async   OpenGL has a thread of its own. Meanwhile start() moves the vertices that rays are
///         tested against; tiles are ready as soon as the rows around them are there.
///
/// Multisample::exact: items that OpenGL is certain of, the others decided by the CPU before start()
///         returns: the cpu engine's items.
///
/// source  Robert and Schoepke 2006, section 4.1
class HybridItems final : public ItemSource {
  public:
    /// context  outlives this, and is current on no other thread during start, wait and the
    ///          destructor
    /// scene    of that context, with any Detail
    HybridItems(const Context& context, SceneBuffers& scene);
    ~HybridItems() override;

    /// Makes the context current nowhere: OpenGL's thread keeps it from frame to frame, since to
    /// change threads takes drivers a while. Before anybody else uses it.
    void let_go();

    /// Does other work of the frame there, once its items are drawn; throws what it throws.
    void with_context(const std::function<void()>& work);

    /// For the frames that follow. Read are multisample, opengl.item_format, .depth_format,
    /// .readback and .readback_chunks.
    void set(const Settings& settings);

    /// throws  ArgumentError: more triangles than the item format holds
    ///         DeviceError: as SceneBuffers and ItemPass
    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override;
    std::size_t wait(const ViewMemory& memory) override;
    void tile(const ViewMemory& memory, int tile, ItemTile& out, std::span<std::uint64_t> holes,
        std::size_t worker) override;

    /// Since the last call.
    HybridTimes take_times();

  private:
    /// What the driver is asked for, while start() runs.
    struct Order {
        const World* world = nullptr;
        Pencil pencil;
        DepthRange range;
    };
    void draw();
    void draw_and_read();
    void report(int rows);
    void find_exact(ViewMemory& memory, Tasks& tasks);

    const Context& context_;
    SceneBuffers& scene_;
    std::optional<ItemPass> pass_; // while the context is there
    std::optional<ItemReadback> readback_;
    std::optional<CertifiedItems> certified_; // made when first asked for
    firsthit::Buffer<std::uint32_t> exact_items_;
    firsthit::Buffer<std::uint32_t> decided_;
    LazyMemory lazy_;
    Multisample multisample_ = Multisample::lazy3;
    OpenGlSettings settings_;
    Order order_;
    int tile_rows_ = 0; // that were said to be ready

    std::mutex mutex_; // guards the following, which the job thread writes
    std::condition_variable changed_;
    bool drawn_ = false;
    int rows_ = 0; // that are there
    std::exception_ptr error_;
    HybridTimes times_;

    std::optional<Current> held_; // by the job thread
    JobThread thread_;
};

} // namespace firsthit::gl
