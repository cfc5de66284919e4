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

PictureCache::Entry* PictureCache::known_entry(std::span<const char> bytes)
{
    const std::size_t hash = std::hash<std::string_view>()(view_of(bytes));
    for (Entry& entry : entries_)
        if (entry.hash == hash && entry.bytes == view_of(bytes)) {
            entry.scene = scene_;
            return &entry;
        }
    return nullptr;
}

PictureCache::Entry& PictureCache::entry_of(std::span<const char> bytes)
{
    if (Entry* const known = known_entry(bytes)) return *known;
    Entry& added = entries_.emplace_back();
    added.hash = std::hash<std::string_view>()(view_of(bytes));
    added.bytes = view_of(bytes);
    added.scene = scene_;
    return added;
}

std::shared_ptr<const Picture> PictureCache::find(std::span<const char> bytes)
{
    const std::lock_guard one_at_a_time(use_);
    const Entry* const entry = known_entry(bytes);
    return entry ? entry->picture : nullptr;
}

void PictureCache::add(std::span<const char> bytes, const Picture& picture)
{
    auto kept = std::make_shared<const Picture>(picture);
    const std::lock_guard one_at_a_time(use_);
    entry_of(bytes).picture = std::move(kept);
}

std::shared_ptr<const Texture> PictureCache::find_texture(
    std::span<const char> bytes, Encoding encoding)
{
    const std::lock_guard one_at_a_time(use_);
    const Entry* const entry = known_entry(bytes);
    return entry ? entry->texture[encoding == Encoding::linear] : nullptr;
}

void PictureCache::add_texture(
    std::span<const char> bytes, Encoding encoding, const Texture& texture)
{
    auto kept = std::make_shared<const Texture>(texture);
    const std::lock_guard one_at_a_time(use_);
    entry_of(bytes).texture[encoding == Encoding::linear] = std::move(kept);
}

std::size_t PictureCache::size()
{
    const std::lock_guard one_at_a_time(use_);
    return entries_.size();
}

} // namespace firsthit
