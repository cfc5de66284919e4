// item_readback.cpp - transfers items from OpenGL to host memory, at once or in chunks.
#include "gl/items/item_readback.h"

#include "gl/device/context.h"

#include <algorithm>

namespace firsthit::gl {
namespace {

/// While it exists, glReadPixels reads the items of the pass.
struct ReadFrom {
    explicit ReadFrom(const ItemPass& pass)
    {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, pass.framebuffer().name());
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
    }
    ~ReadFrom() { glBindFramebuffer(GL_READ_FRAMEBUFFER, 0); }
};

/// Whether pixels have to be converted to items: see decoded().
bool needs_decoding(ItemFormat format)
{
    return format == ItemFormat::rgb8;
}

} // namespace

void ItemReadback::start(const ItemPass& pass, Readback mode, int chunks)
{
    pass_ = &pass;
    width_ = pass.width();
    height_ = pass.height();
    rows_ready_ = 0;
    asked_ = 0;
    for (Fence& fence : fences_) fence.reset();
    const std::size_t pixels = offset(height_);
    const bool decodes = needs_decoding(pass.format());
    if (mode == Readback::sync || decodes) host_.resize(pixels);
    if (mode == Readback::sync) {
        const ReadFrom from(pass);
        const PixelLayout layout = pixel_layout(pass.format());
        glReadPixels(0, 0, width_, height_, layout.format, layout.type, host_.data());
        check("reading items");
        if (decodes) decode(0, height_, host_.data());
        items_ = host_.data();
        rows_ready_ = height_;
        return;
    }
    transfer_.resize(pixels * sizeof(std::uint32_t),
        GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT | GL_CLIENT_STORAGE_BIT);
    items_ = decodes ? host_.data() : reinterpret_cast<const std::uint32_t*>(transfer_.mapped());
    chunk_rows_ = std::max(1, (height_ + chunks - 1) / chunks);
    fences_.resize(std::size_t((height_ + chunk_rows_ - 1) / chunk_rows_));
    const ReadFrom from(pass);
    while (hardware_ && asked_ < fences_.size()) prefetch(asked_++);
    check("reading items");
}

void ItemReadback::prefetch(std::size_t chunk)
{
    const int y = int(chunk) * chunk_rows_;
    const PixelLayout layout = pixel_layout(pass_->format());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, transfer_.name());
    glReadPixels(0, y, width_, std::min(chunk_rows_, height_ - y), layout.format, layout.type,
        reinterpret_cast<void*>(offset(y) * sizeof(std::uint32_t)));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    fences_[chunk].insert();
}

int ItemReadback::wait()
{
    if (rows_ready_ >= height_) return height_;
    const auto chunk = std::size_t(rows_ready_ / chunk_rows_);
    if (asked_ <= chunk) {
        const ReadFrom from(*pass_);
        prefetch(asked_++);
    }
    fences_[chunk].wait("reading items");
    const int last = std::min(rows_ready_ + chunk_rows_, height_);
    if (needs_decoding(pass_->format()))
        decode(rows_ready_, last, reinterpret_cast<const std::uint32_t*>(transfer_.mapped()));
    if (last == height_) check("reading items");
    return rows_ready_ = last;
}

void ItemReadback::decode(int first, int last, const std::uint32_t* pixels)
{
    const ItemFormat format = pass_->format();
    std::uint32_t* const items = host_.data();
    for (std::size_t k = offset(first); k < offset(last); ++k)
        items[k] = decoded(format, pixels[k]);
}

} // namespace firsthit::gl
