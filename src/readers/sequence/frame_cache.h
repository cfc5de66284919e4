// frame_cache.h - the few frames of a sequence that are in memory, and the one that is read ahead.
#pragma once

#include "readers/sequence/sequence_frame.h"

#include <cstddef>
#include <functional>
#include <future>
#include <memory>
#include <utility>
#include <vector>

namespace firsthit {

/// Reads frames when they are asked for and keeps those that were used last. Not thread-safe; it has at
/// most one thread of its own, which reads ahead.
class FrameCache {
  public:
    using Frame = std::shared_ptr<const SequenceFrame>;

    /// Two are around a time and two are read ahead; one more would only take memory.
    static constexpr std::size_t kKept = 4;

    /// read  makes the frame of a number; called from several threads
    explicit FrameCache(std::function<SequenceFrame(std::size_t)> read) : read_(std::move(read)) {}

    /// throws  what reading it throws; the next call reads it again
    Frame frame(std::size_t number);

    /// Starts to read a frame on a thread, unless it is there or another one is being read. An error
    /// comes when the frame is asked for.
    void read_ahead(std::size_t number);

    bool has(std::size_t number) const;

  private:
    struct Entry {
        std::size_t number = 0;
        std::shared_future<Frame> frame; // destroying it waits for the thread
    };
    Frame make(std::size_t number) const;
    void drop_oldest();

    std::function<SequenceFrame(std::size_t)> read_;
    std::vector<Entry> entries_; // the one used last at the end
};

} // namespace firsthit
