// item_readback.h - transfers items from OpenGL to host memory, at once or in chunks.
#pragma once

#include "base/buffer.h"
#include "gl/items/item_pass.h"
#include "gl/device/objects.h"

#include <firsthit/options/opengl_options.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit::gl {

/// Transfers one item buffer at a time. Its memory is kept for the next one.
class ItemReadback {
  public:
    explicit ItemReadback(const Context& context) : hardware_(context.is_hardware()) {}

    /// Begins the transfer of the items that were drawn last. Readback::sync: it is done when this
    /// returns. Readback::async: chunks of whole rows are copied to a pixel buffer object that
    /// stays mapped, with a fence after each; wait() waits for the next one. All chunks are
    /// requested at once from hardware, but one at a time from a software driver, which copies
    /// during the request.
    ///
    /// chunks  for async: the number of chunks of the picture, 1 or more
    /// throws  DeviceError: no memory, lost context
    void start(const ItemPass& pass, Readback mode, int chunks);

    /// Waits for the next chunk. The context must be current.
    /// returns  the number of rows that have arrived, from the top
    /// throws  DeviceError: lost context
    int wait();

    int rows_ready() const { return rows_ready_; }
    int width() const { return width_; }
    int height() const { return height_; }

    /// The items, (height, width), of which rows_ready() rows have arrived. The address stays the
    /// same until the next start().
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
    firsthit::Buffer<std::uint32_t> host_; // for sync, or decoded items
    Buffer transfer_;                      // for async
    std::vector<Fence> fences_;            // (chunks)
    std::size_t asked_ = 0;                // number of requested chunks
    const std::uint32_t* items_ = nullptr;
    int width_ = 0, height_ = 0;
    int chunk_rows_ = 1;
    int rows_ready_ = 0;
};

} // namespace firsthit::gl
