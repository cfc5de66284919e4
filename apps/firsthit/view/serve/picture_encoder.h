// picture_encoder.h - the thread that encodes pictures for pages.
#pragma once

#include "view/frames/frame_request.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace firsthit::cli::view {

/// A picture as it is sent: twelve bytes in front, the number, whether it is without loss, and the number of the state
/// that it shows, each of four bytes with the lowest first; then a .png or a .jpg.
struct EncodedPicture {
    std::uint32_t number = 0;
    bool lossless = false;
    std::shared_ptr<const std::string> bytes{}; // which a slow page may keep longer than the frame
    std::shared_ptr<const ShownFrame> frame{};  // that it shows
    double ms = 0;                              // that encoding took
};

/// Encodes the latest picture that is wanted; those before it that were not begun are left out.
class PictureEncoder {
  public:
    /// has_news  called on the encoder's thread when there is a picture to fetch
    explicit PictureEncoder(std::function<void()> has_news);
    ~PictureEncoder();
    PictureEncoder(const PictureEncoder&) = delete;
    PictureEncoder& operator=(const PictureEncoder&) = delete;

    /// lossless  as .png; else as .jpg, where the library was built with libjpeg
    void want(std::uint32_t number, const std::shared_ptr<const ShownFrame>& frame, bool lossless);

    /// The latest picture; null: none yet.
    std::shared_ptr<const EncodedPicture> latest() const;

  private:
    struct Wanted {
        std::uint32_t number = 0;
        std::shared_ptr<const ShownFrame> frame{};
        bool lossless = false;
    };
    void run(const std::stop_token& end);

    mutable std::mutex mutex_;
    std::condition_variable_any wakes_;
    std::optional<Wanted> wanted_;
    std::shared_ptr<const EncodedPicture> latest_;
    std::function<void()> has_news_;
    std::jthread thread_; // last: it uses all others
};

} // namespace firsthit::cli::view
