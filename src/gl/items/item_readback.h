// item_readback.h - items from OpenGL to host memory, at once or in chunks.
#pragma once

#include "base/buffer.h"
#include "gl/items/item_pass.h"
#include "gl/device/objects.h"

#include <firsthit/options/opengl_options.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// The transfer of one item picture at a time. Its memory is kept.
class ItemReadback {
  public:
    explicit ItemReadback(const Context& context) : hardware_(context.is_hardware()) {}

    /// Begins the transfer of what was drawn last. sync: it is done when this returns. async:
    /// chunks of whole rows go through a pixel buffer object that stays mapped, each behind a
    /// fence; wait() tells when they are there. Hardware is asked for all chunks at once; a
    /// software driver, which copies while it is asked, for one at a time.
    ///
    /// chunks  1 or more, of the picture; async
    /// throws  DeviceError: no memory, lost context
    void start(const ItemPass& pass, Readback mode, int chunks);

    /// Waits for the next chunk; the context has to be current.
    /// returns  the number of rows that are there, from the top; all of them in the end
    /// throws  DeviceError: lost context
    int wait();

    int rows_ready() const { return rows_ready_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// (height, width) triangle ids, of which rows_ready() rows are there. Stays in place until
    /// the next start.
    std::span<const std::uint32_t> picture() const
    {
        return {items_, std::size_t(width_) * std::size_t(height_)};
    }

  private:
    std::size_t offset(int row) const { return std::size_t(row) * std::size_t(width_); }
    void prefetch(std::size_t chunk);
    void decode(int first, int last, const std::uint32_t* pixels);

    bool hardware_;
    const ItemPass* pass_ = nullptr;
    firsthit::Buffer<std::uint32_t> host_; // sync, or decoded
    Buffer transfer_;                      // async
    std::vector<Fence> fences_;            // a chunk each
    std::size_t asked_ = 0;                // chunks
    const std::uint32_t* items_ = nullptr;
    int width_ = 0, height_ = 0;
    int chunk_rows_ = 1;
    int rows_ready_ = 0;
};

} // namespace firsthit::gl
