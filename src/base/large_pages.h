// large_pages.h - asks the system to use large pages for large arrays.
#pragma once

#include <cstddef>
#include <vector>

namespace firsthit {

/// Requests large pages for memory that has not been written yet. Scattered reads in some megabytes
/// otherwise spend much of their time on TLB misses. Only a hint: has no effect where the system
/// has no large pages.
void request_large_pages(void* memory, std::size_t bytes);

/// values.resize(count), but requests large pages if the vector has to grow. Keeps the elements.
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
