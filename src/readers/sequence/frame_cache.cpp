// frame_cache.cpp - the few frames of a sequence that are in memory, and the one that is read ahead.
#include "readers/sequence/frame_cache.h"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace firsthit {

FrameCache::Frame FrameCache::make(std::size_t number) const
{
    return std::make_shared<const SequenceFrame>(read_(number));
}

bool FrameCache::has(std::size_t number) const
{
    return std::any_of(entries_.begin(), entries_.end(),
        [number](const Entry& entry) { return entry.number == number; });
}

/// Before a frame is read, so that never more than kKept are in memory.
void FrameCache::drop_oldest()
{
    if (entries_.size() >= kKept) entries_.erase(entries_.begin());
}

FrameCache::Frame FrameCache::frame(std::size_t number)
{
    const auto found = std::find_if(entries_.begin(), entries_.end(),
        [number](const Entry& entry) { return entry.number == number; });
    if (found != entries_.end()) {
        std::rotate(found, found + 1, entries_.end());
        try {
            return entries_.back().frame.get();
        } catch (...) {
            entries_.pop_back();
            throw;
        }
    }
    drop_oldest();
    Frame frame = make(number);
    std::promise<Frame> made;
    made.set_value(frame);
    entries_.push_back({number, made.get_future().share()});
    return frame;
}

void FrameCache::read_ahead(std::size_t number)
{
    if (has(number)) return;
    for (const Entry& entry : entries_)
        if (entry.frame.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    drop_oldest();
    try {
        entries_.push_back({number,
            std::async(std::launch::async, [this, number] { return make(number); }).share()});
    } catch (const std::system_error&) {
        // There is no thread to be had: the frame is read when it is asked for.
    }
}

} // namespace firsthit
