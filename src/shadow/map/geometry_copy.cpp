// geometry_copy.cpp - has the geometry changed since it was last looked at?
#include "shadow/map/geometry_copy.h"

#include <algorithm>
#include <cstring>

namespace firsthit {
namespace {

constexpr std::size_t kGrain = 16384; // elements

/// Makes elements [first, last) of `copy` equal to those of `array`. Returns whether they were
/// different.
template <class T>
bool follow_range(const std::vector<T>& array, std::size_t first, std::size_t last, Buffer<T>& copy)
{
    const std::size_t bytes = (last - first) * sizeof(T);
    if (std::memcmp(&copy[first], &array[first], bytes) == 0) return false;
    std::memcpy(&copy[first], &array[first], bytes);
    return true;
}

/// Makes `copy` equal to `array`. Returns the start of the first range that was different, or the
/// array's size; 0 where sizes were.
template <class T>
std::size_t follow_array(const std::vector<T>& array, Buffer<T>& copy, Tasks& tasks)
{
    if (array.size() != copy.size()) {
        copy.resize(array.size());
        tasks.for_ranges(array.size(), kGrain, [&](std::size_t first, std::size_t last) {
            std::memcpy(&copy[first], &array[first], (last - first) * sizeof(T));
        });
        return 0;
    }
    std::atomic<std::size_t> changed = array.size();
    tasks.for_ranges(array.size(), kGrain, [&](std::size_t first, std::size_t last) {
        if (!follow_range(array, first, last, copy)) return;
        std::size_t least = changed.load(std::memory_order_relaxed);
        while (first < least && !changed.compare_exchange_weak(least, first)) {
        }
    });
    return changed;
}

/// Whether the positions that moved last time have moved again.
bool moves_again(const std::vector<glm::vec3>& position, GeometryCopy& copy)
{
    if (!copy.moving || copy.moved >= position.size() || copy.position.size() != position.size())
        return false;
    return follow_range(
        position, copy.moved, std::min(copy.moved + kGrain, position.size()), copy.position);
}

} // namespace

void follow(const World& world, bool anyway, GeometryCopy& copy, Tasks& tasks)
{
    const bool skips = anyway && copy.anyway;
    copy.anyway = anyway;
    if (skips || moves_again(world.position, copy)) {
        copy.is_old = true;
        ++copy.version;
        return;
    }
    const std::vector<glm::uvec3>& index = world.scene->index;
    const bool resized = copy.position.size() != world.position.size();
    copy.moved = follow_array(world.position, copy.position, tasks);
    copy.moving = resized || copy.moved < world.position.size();
    const bool relisted = copy.index.size() != index.size();
    const bool rewired = follow_array(index, copy.index, tasks) < index.size() || relisted;
    if (copy.moving || rewired || copy.is_old) ++copy.version;
    copy.is_old = false;
}

} // namespace firsthit
