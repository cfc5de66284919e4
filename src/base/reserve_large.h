// reserve_large.h - room in vectors, in large pages.
#pragma once

#include "base/large_pages.h"

#include <cstddef>
#include <vector>

namespace firsthit {

/// values.reserve(count), but requests large pages if the vector has to grow. Keeps the elements.
template <class T>
void reserve_in_large_pages(std::vector<T>& values, std::size_t count)
{
    if (count <= values.capacity()) return;
    std::vector<T> grown;
    grown.reserve(count);
    request_large_pages(grown.data(), count * sizeof(T));
    grown.assign(values.begin(), values.end());
    values.swap(grown);
}

} // namespace firsthit
