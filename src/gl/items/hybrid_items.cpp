// hybrid_items.cpp - items drawn by OpenGL for rays on the CPU.
#include "gl/items/hybrid_items.h"

#include "base/stopwatch.h"
#include "hits/item_repair.h"
#include "visibility/bin/project.h"

#include <algorithm>
#include <utility>

namespace firsthit::gl {

HybridItems::HybridItems(const Context& context, SceneBuffers& scene)
    : context_(context),
      scene_(scene)
{
    const Current current(context_);
    pass_.emplace(context_);
    readback_.emplace(context_);
}

HybridItems::~HybridItems()
{
    let_go();
    const Current current(context_);
    certified_.reset();
    readback_.reset();
    pass_.reset();
}

void HybridItems::let_go()
{
    thread_.start([this] { held_.reset(); });
    thread_.wait();
}

void HybridItems::with_context(const std::function<void()>& work)
{
    std::exception_ptr error;
    thread_.start([&] {
        try {
            if (!held_) held_.emplace(context_);
            work();
        } catch (...) {
            held_.reset();
            error = std::current_exception();
        }
    });
    thread_.wait();
    if (error) std::rethrow_exception(error);
}

void HybridItems::set(const Settings& settings)
{
    multisample_ = settings.multisample;
    settings_ = settings.opengl;
}

/// Draws the items. The context must be current.
void HybridItems::draw()
{
    Stopwatch watch;
    scene_.pose(*order_.world, order_.pencil);
    pass_->draw(scene_, order_.pencil, settings_.item_format, settings_.depth_format, order_.range);
    glFlush();
    const std::lock_guard lock(mutex_);
    times_.draw_ms += watch.lap_ms();
}

/// The job of OpenGL's thread: draws the items and reads them back.
void HybridItems::draw_and_read()
{
    try {
        if (!held_) held_.emplace(context_);
        draw();
        {
            const std::lock_guard lock(mutex_);
            drawn_ = true;
        }
        changed_.notify_all();
        Stopwatch watch;
        readback_->start(*pass_, Readback::async, settings_.readback_chunks);
        while (readback_->rows_ready() < readback_->height()) {
            const int rows = readback_->wait();
            if (rows < readback_->height()) report(rows);
        }
        const std::lock_guard lock(mutex_);
        times_.transfer_ms += watch.lap_ms();
    } catch (...) {
        held_.reset();
        const std::lock_guard lock(mutex_);
        error_ = std::current_exception();
        drawn_ = true;
    }
    report(order_.pencil.height); // also after errors, so that nobody waits forever
}

void HybridItems::report(int rows)
{
    {
        const std::lock_guard lock(mutex_);
        rows_ = rows;
    }
    changed_.notify_all();
}

bool HybridItems::start(const World& world, ViewMemory& memory, Tasks& tasks)
{
    thread_.wait(); // if the last frame was cancelled
    check_triangles(settings_.item_format, world.scene->index.size());
    take_triangles(*world.scene, memory);
    mode_ = memory.cutouts.any() ? Multisample::exact : multisample_;
    memory.in_view_count = memory.entry_count = 0; // triangles are not binned
    order_ = {&world, memory.pencil, {}};
    drawn_ = false;
    rows_ = tile_rows_ = 0;
    error_ = nullptr;

    if (mode_ == Multisample::exact || settings_.readback == Readback::sync) let_go();
    if (mode_ == Multisample::exact) {
        find_exact(memory, tasks);
        return true;
    }
    // fixed24 needs the range of depths before drawing. Otherwise the CPU projects while OpenGL
    // draws.
    const bool projects_first = settings_.depth_format == DepthFormat::fixed24;
    if (projects_first) {
        project_vertices(world.position, memory.pencil, memory, tasks);
        order_.range = fit_depth(memory.corner.span(), memory.index, memory.pencil, tasks);
    }

    if (settings_.readback == Readback::sync) {
        Stopwatch watch;
        {
            const Current current(context_);
            draw();
            Stopwatch transfer;
            readback_->start(*pass_, Readback::sync, 1);
            times_.transfer_ms += transfer.lap_ms();
        }
        rows_ = readback_->height();
        times_.waiting_ms += watch.lap_ms();
        if (!projects_first) project_vertices(world.position, memory.pencil, memory, tasks);
        return true;
    }
    thread_.start([this] { draw_and_read(); });
    try {
        if (!projects_first) project_vertices(world.position, memory.pencil, memory, tasks);
    } catch (...) {
        thread_.wait(); // it reads the world
        throw;
    }
    Stopwatch watch;
    std::unique_lock lock(mutex_);
    // After this, OpenGL's thread does not read the world.
    changed_.wait(lock, [&] { return drawn_; });
    times_.waiting_ms += watch.lap_ms();
    if (!error_) return true;
    const std::exception_ptr error = error_;
    lock.unlock();
    thread_.wait();
    std::rethrow_exception(error);
}

/// Finds exact items: OpenGL's where it is certain, otherwise the CPU's.
void HybridItems::find_exact(ViewMemory& memory, Tasks& tasks)
{
    const auto width = std::size_t(memory.pencil.width);
    exact_items_.resize(width * std::size_t(memory.pencil.height));
    project_vertices(order_.world->position, memory.pencil, memory, tasks);
    std::span<const ListedSample> uncertain;
    {
        Stopwatch watch;
        const Current current(context_);
        if (!certified_) certified_.emplace(context_);
        scene_.lend_eye_space(*order_.world, order_.pencil, memory.corner.span());
        certified_->draw(scene_, order_.pencil, memory.cutouts);
        times_.draw_ms += watch.lap_ms();
        certified_->read_items(exact_items_.span());
        uncertain = certified_->read_uncertain();
        times_.transfer_ms += watch.lap_ms();
    }
    const std::span<const std::uint32_t> decided =
        find_listed_items(memory.pencil, memory, {uncertain}, lazy_, tasks);
    for (std::size_t k = 0; k < uncertain.size(); ++k)
        exact_items_[uncertain[k].y * width + uncertain[k].x] = decided[k];
    times_.uncertain += uncertain.size();
    rows_ = memory.pencil.height;
}

std::size_t HybridItems::wait(const ViewMemory& memory)
{
    const int reach = reach_of(mode_);
    // The number of rows of tiles whose items, and the neighbours of these, have arrived.
    const auto ready = [&](int rows) {
        return rows >= memory.pencil.height ? memory.tiles_y
                                            : std::max(0, rows - reach) / memory.tile_size;
    };
    Stopwatch watch;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return ready(rows_) > tile_rows_; });
    times_.waiting_ms += watch.lap_ms();
    if (error_) std::rethrow_exception(error_);
    tile_rows_ = ready(rows_);
    return std::size_t(tile_rows_) * std::size_t(memory.tiles_x);
}

void HybridItems::tile(const ViewMemory& memory, int tile, TileItems& out,
    std::span<std::uint64_t> holes, std::size_t /*worker*/)
{
    const bool exact = mode_ == Multisample::exact;
    const PictureTile picture{memory, exact ? exact_items_.span() : readback_->picture(), tile};
    repair_tile_items(memory, picture, mode_, out, holes);
}

HybridTimes HybridItems::take_times()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(times_, {});
}

} // namespace firsthit::gl
