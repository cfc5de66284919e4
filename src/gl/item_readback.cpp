// item_readback.cpp - items from OpenGL to host memory, at once or in chunks.
#include "gl/item_readback.h"

#include "gl/context.h"

#include <algorithm>

namespace firsthit::gl {

void ItemReadback::start(const ItemPass& pass, Readback mode, int chunks)
{
    width_ = pass.width();
    height_ = pass.height();
    rows_ready_ = 0;
    const std::size_t pixels = std::size_t(width_) * std::size_t(height_);
    const PixelLayout layout = pixel_layout(pass.format());
    for (Fence& fence : fences_) fence.reset();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, pass.framebuffer().name());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    if (mode == Readback::sync) {
        host_.resize(pixels);
        glReadPixels(0, 0, width_, height_, layout.format, layout.type, host_.data());
        pixels_ = host_.data();
        rows_ready_ = height_;
    } else {
        transfer_.resize(pixels * sizeof(std::uint32_t),
            GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT | GL_CLIENT_STORAGE_BIT);
        pixels_ = reinterpret_cast<const std::uint32_t*>(transfer_.mapped());
        chunk_rows_ = std::max(1, (height_ + chunks - 1) / chunks);
        fences_.resize(std::size_t((height_ + chunk_rows_ - 1) / chunk_rows_));
        glBindBuffer(GL_PIXEL_PACK_BUFFER, transfer_.name());
        for (std::size_t k = 0; k < fences_.size(); ++k) {
            const int y = int(k) * chunk_rows_;
            const std::size_t offset = std::size_t(y) * std::size_t(width_) * sizeof(std::uint32_t);
            glReadPixels(0, y, width_, std::min(chunk_rows_, height_ - y), layout.format,
                layout.type, reinterpret_cast<void*>(offset));
            fences_[k].insert();
        }
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    check("reading items");
}

int ItemReadback::wait()
{
    if (rows_ready_ < height_) {
        fences_[std::size_t(rows_ready_ / chunk_rows_)].wait("reading items");
        rows_ready_ = std::min(rows_ready_ + chunk_rows_, height_);
    }
    return rows_ready_;
}

} // namespace firsthit::gl
