// picture_encoder.cpp - the thread that encodes pictures for pages.
#include "view/serve/picture_encoder.h"

#include "common/stopwatch.h"
#include "view/frames/write_pixels.h"

#include <firsthit/picture.h>

#include <algorithm>
#include <utility>

namespace firsthit::cli::view {
namespace {

/// Of pictures of something that moves.
constexpr int kMovingQuality = 80;

bool has_jpeg()
{
    static const bool kHas = [] {
        const auto endings = picture_endings();
        return std::find(endings.begin(), endings.end(), ".jpg") != endings.end();
    }();
    return kHas;
}

void add_word(std::string& bytes, std::uint32_t word)
{
    for (int k = 0; k < 4; ++k) bytes.push_back(static_cast<char>((word >> (8 * k)) & 255));
}

} // namespace

PictureEncoder::PictureEncoder(std::function<void()> has_news)
    : has_news_(std::move(has_news)),
      thread_([this](const std::stop_token& end) { run(end); })
{
}

PictureEncoder::~PictureEncoder() = default; // the thread is asked to stop, and waited for

void PictureEncoder::want(
    std::uint32_t number, const std::shared_ptr<const ShownFrame>& frame, bool lossless)
{
    {
        const std::lock_guard lock(mutex_);
        wanted_ = {number, frame, lossless};
    }
    wakes_.notify_all();
}

std::shared_ptr<const EncodedPicture> PictureEncoder::latest() const
{
    const std::lock_guard lock(mutex_);
    return latest_;
}

void PictureEncoder::run(const std::stop_token& end)
{
    for (;;) {
        Wanted wanted;
        {
            std::unique_lock lock(mutex_);
            if (!wakes_.wait(lock, end, [this] { return wanted_.has_value(); })) return;
            wanted = *std::exchange(wanted_, {});
        }
        const Stopwatch watch;
        const ShownFrame& frame = *wanted.frame;
        auto encoded = std::make_shared<EncodedPicture>();
        encoded->number = wanted.number;
        encoded->lossless = wanted.lossless || !has_jpeg();
        encoded->frame = wanted.frame;
        auto bytes = std::make_shared<std::string>();
        add_word(*bytes, wanted.number);
        add_word(*bytes, encoded->lossless ? 1 : 0);
        add_word(*bytes, static_cast<std::uint32_t>(frame.request.number));
        try {
            *bytes += encoded->lossless
                          ? encode_png(frame.rgba, frame.width, frame.height, true)
                          : encode_jpeg(frame.rgba, frame.width, frame.height, kMovingQuality);
        } catch (const std::exception&) {
            continue; // out of memory: the next picture may have it
        }
        encoded->bytes = std::move(bytes);
        encoded->ms = watch.ms();
        {
            const std::lock_guard lock(mutex_);
            latest_ = encoded;
        }
        has_news_();
    }
}

} // namespace firsthit::cli::view
