// picture_cache.cpp - pictures that were decoded for the last frames of a sequence, found again by their bytes.
#include "readers/image/picture_cache.h"

#include <functional>
#include <string_view>
#include <utility>

namespace firsthit {
namespace {

thread_local PictureCache* cache_of_thread = nullptr;

std::string_view view_of(std::span<const char> bytes)
{
    return {bytes.data(), bytes.size()};
}

} // namespace

PictureCache::Use::Use(PictureCache& cache) : before_(std::exchange(cache_of_thread, &cache))
{
    cache.begin_scene();
}

PictureCache::Use::~Use()
{
    cache_of_thread = before_;
}

PictureCache* PictureCache::current()
{
    return cache_of_thread;
}

void PictureCache::begin_scene()
{
    const std::lock_guard one_at_a_time(use_);
    ++scene_;
    entries_.remove_if([&](const Entry& entry) { return entry.scene + kKept < scene_; });
}

PictureCache::Entry* PictureCache::entry_of(std::span<const char> bytes, std::size_t hash)
{
    for (Entry& entry : entries_)
        if (entry.hash == hash && entry.bytes == view_of(bytes)) return &entry;
    return nullptr;
}

std::shared_ptr<const Picture> PictureCache::find(std::span<const char> bytes)
{
    const std::size_t hash = std::hash<std::string_view>()(view_of(bytes));
    const std::lock_guard one_at_a_time(use_);
    Entry* const entry = entry_of(bytes, hash);
    if (!entry) return nullptr;
    entry->scene = scene_;
    return entry->picture;
}

void PictureCache::add(std::span<const char> bytes, const Picture& picture)
{
    const std::size_t hash = std::hash<std::string_view>()(view_of(bytes));
    const std::lock_guard one_at_a_time(use_);
    if (entry_of(bytes, hash)) return; // another thread was faster
    entries_.push_back(
        {hash, std::string(view_of(bytes)), std::make_shared<const Picture>(picture), scene_});
}

std::size_t PictureCache::size()
{
    const std::lock_guard one_at_a_time(use_);
    return entries_.size();
}

} // namespace firsthit
