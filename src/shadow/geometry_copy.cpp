// geometry_copy.cpp - has the geometry changed since it was last looked at?
#include "shadow/geometry_copy.h"

#include <cstring>

namespace firsthit {
namespace {

/// Makes `copy` equal to `array`. Returns whether it was different.
template <class T>
bool follow_array(const std::vector<T>& array, Buffer<T>& copy, Tasks& tasks)
{
    constexpr std::size_t kGrain = 16384; // elements
    std::atomic<bool> changed = array.size() != copy.size();
    if (changed) copy.resize(array.size());
    const bool all = changed;
    tasks.for_ranges(array.size(), kGrain, [&](std::size_t first, std::size_t last) {
        const std::size_t bytes = (last - first) * sizeof(T);
        if (!all && std::memcmp(&copy[first], &array[first], bytes) == 0) return;
        std::memcpy(&copy[first], &array[first], bytes);
        changed.store(true, std::memory_order_relaxed);
    });
    return changed;
}

} // namespace

void follow(const World& world, GeometryCopy& copy, Tasks& tasks)
{
    const bool was_moving = copy.moving;
    copy.moving = follow_array(world.position, copy.position, tasks);
    if (copy.moving && was_moving) {
        copy.index_is_old = true;
        ++copy.version;
        return;
    }
    const bool rewired = follow_array(world.scene->index, copy.index, tasks);
    if (copy.moving || rewired || copy.index_is_old) ++copy.version;
    copy.index_is_old = false;
}

} // namespace firsthit
