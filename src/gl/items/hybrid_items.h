// hybrid_items.h - items drawn by OpenGL for rays on the CPU.
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

/// The times of OpenGL in a frame, milliseconds, summed over all sections of the picture.
struct HybridTimes {
    double draw_ms = 0;          // posing vertices and sending triangles to the driver
    double transfer_ms = 0;      // from there until all items are in host memory
    double waiting_ms = 0;       // how long the CPU waited for it
    std::uint64_t uncertain = 0; // samples that the CPU decided
};

/// The item source of the hybrid engine: draws the items of a section of the picture, reads them
/// back, and repairs them tile by tile on the CPU (hits/item_repair.h).
///
/// Readback::sync      the caller's thread does everything before start() returns
/// Readback::async     OpenGL has a thread of its own. Meanwhile start() projects the vertices that
///                     rays are tested against. A tile is ready as soon as the rows around it have
///                     arrived
/// Multisample::exact  OpenGL finds the items that it is certain of, and the CPU decides the others
///                     before start() returns. The items are those of the cpu engine. Scenes with cut-outs
///                     (exact/cutouts.h) are always drawn so
///
/// source  Robert and Schoepke 2006, section 4.1
class HybridItems final : public ItemSource {
  public:
    /// context  outlives this, and is current on no other thread during start, wait and the
    ///          destructor
    /// scene    of that context, with any Detail
    HybridItems(const Context& context, SceneBuffers& scene);
    ~HybridItems() override;

    /// Releases the context. OpenGL's thread keeps it current from frame to frame, because drivers
    /// take a while to change threads. To be called before another thread uses the context.
    void let_go();

    /// Runs other work of the frame on OpenGL's thread, after its items were drawn.
    /// throws  what `work` throws
    void with_context(const std::function<void()>& work);

    /// Sets the options of the frames that follow: settings.multisample and settings.opengl, except
    /// for its passes.
    void set(const Settings& settings);

    /// throws  ArgumentError: more triangles than the item format holds
    ///         DeviceError: as SceneBuffers and ItemPass
    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override;
    std::size_t wait(const ViewMemory& memory) override;
    void tile(const ViewMemory& memory, int tile, TileItems& out, std::span<std::uint64_t> holes,
        std::size_t worker) override;

    /// The times since the last call.
    HybridTimes take_times();

  private:
    /// What is to be drawn. Valid while start() runs.
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
    std::optional<ItemPass> pass_; // deleted while the context is current
    std::optional<ItemReadback> readback_;
    std::optional<CertifiedItems> certified_; // made when first needed
    firsthit::Buffer<std::uint32_t> exact_items_;
    LazyMemory lazy_;
    Multisample multisample_ = Multisample::lazy3; // as it was set
    Multisample mode_ = Multisample::lazy3;        // of the frame: exact where there are cut-outs
    OpenGlSettings settings_;
    Order order_;
    int tile_rows_ = 0; // rows of tiles that wait() has reported

    std::mutex mutex_; // guards the following, which the job thread writes
    std::condition_variable changed_;
    bool drawn_ = false;
    int rows_ = 0; // rows of items that have arrived
    std::exception_ptr error_;
    HybridTimes times_;

    std::optional<Current> held_; // the context, while the job thread has it
    JobThread thread_;
};

} // namespace firsthit::gl
