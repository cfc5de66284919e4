// large_pages.h - asks the system to back large memory by large pages.
#pragma once

#include <cstddef>
#include <vector>

namespace firsthit {

/// Memory that has not been written yet. Scattered reads of some megabytes otherwise spend much of
/// their time in finding out where a page is. What cannot be had is done without.
void request_large_pages(void* memory, std::size_t bytes);

/// values.resize(count), in large pages where it has to grow. What was in it is kept as by resize.
template <class T>
void resize_in_large_pages(std::vector<T>& values, std::size_t count)
{
    if (count > values.capacity()) {
        std::vector<T> grown;
        grown.reserve(count);
        request_large_pages(grown.data(), count * sizeof(T));
        grown.assign(values.begin(), values.end());
        values.swap(grown);
    }
    values.resize(count);
}

} // namespace firsthit
