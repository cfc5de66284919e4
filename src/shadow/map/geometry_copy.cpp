// geometry_copy.cpp - finds out whether the geometry has changed since the last frame.
#include "shadow/map/geometry_copy.h"

#include <algorithm>
#include <cstring>

namespace firsthit {
namespace {

constexpr std::size_t kGrain = 16384; // elements

/// Copies elements [first, last) of `array` to `copy`. Returns whether they differed.
template <class T>
bool update_range(const std::vector<T>& array, std::size_t first, std::size_t last, Buffer<T>& copy)
{
    const std::size_t bytes = (last - first) * sizeof(T);
    if (std::memcmp(&copy[first], &array[first], bytes) == 0) return false;
    std::memcpy(&copy[first], &array[first], bytes);
    return true;
}

/// Copies `array` to `copy`. Returns the start of the first range that differed: the array's size
/// if none did, 0 if the sizes differed.
template <class T>
std::size_t update_array(const std::vector<T>& array, Buffer<T>& copy, Tasks& tasks)
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
        if (!update_range(array, first, last, copy)) return;
        std::size_t least = changed.load(std::memory_order_relaxed);
        while (first < least && !changed.compare_exchange_weak(least, first)) {
        }
    });
    return changed;
}

/// Whether the range of positions that moved first in the last full comparison has moved again.
bool moves_again(const std::vector<glm::vec3>& position, GeometryCopy& copy)
{
    if (!copy.moving || copy.moved >= position.size() || copy.position.size() != position.size())
        return false;
    return update_range(
        position, copy.moved, std::min(copy.moved + kGrain, position.size()), copy.position);
}

} // namespace

void update_copy(const World& world, bool remake_all, GeometryCopy& copy, Tasks& tasks)
{
    const bool skips = remake_all && copy.remade_all;
    copy.remade_all = remake_all;
    if (skips || moves_again(world.position, copy)) {
        copy.is_stale = true;
        ++copy.version;
        return;
    }
    const std::vector<glm::uvec3>& index = world.scene->index;
    const bool resized = copy.position.size() != world.position.size();
    copy.moved = update_array(world.position, copy.position, tasks);
    copy.moving = resized || copy.moved < world.position.size();
    const bool relisted = copy.index.size() != index.size();
    const bool rewired = update_array(index, copy.index, tasks) < index.size() || relisted;
    if (copy.moving || rewired || copy.is_stale) ++copy.version;
    copy.is_stale = false;
}

} // namespace firsthit
