// item_readback.h - items from OpenGL to host memory, at once or in chunks.
#pragma once

#include "gl/item_pass.h"
#include "gl/objects.h"

#include <firsthit/render.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// The transfer of one item picture at a time.
class ItemReadback {
  public:
    /// Begins the transfer of what was drawn last. sync: it is done when this returns. async:
    /// chunks of whole rows go through a pixel buffer object that stays mapped, each behind a
    /// fence; wait() tells when they are there.
    ///
    /// chunks  1 or more; async
    /// throws  DeviceError: no memory
    void start(const ItemPass& pass, Readback mode, int chunks);

    /// Waits for the next chunk.
    /// returns  the number of rows that are there, from the top; all of them in the end
    /// throws  DeviceError: lost context
    int wait();

    int rows_ready() const { return rows_ready_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// Pixels of a row that is there: see decoded (item_pass.h).
    std::span<const std::uint32_t> row(int y) const
    {
        return {pixels_ + std::size_t(y) * std::size_t(width_), std::size_t(width_)};
    }

  private:
    firsthit::Buffer<std::uint32_t> host_; // sync
    Buffer transfer_;                      // async
    std::vector<Fence> fences_;            // a chunk each
    const std::uint32_t* pixels_ = nullptr;
    int width_ = 0, height_ = 0;
    int chunk_rows_ = 1;
    int rows_ready_ = 0;
};

} // namespace firsthit::gl
