// kept_copy.h - tells whether an array has changed since it was last uploaded.
#pragma once

#include "base/buffer.h"

#include <cstring>
#include <span>

namespace firsthit::gl {

/// A copy of an array, to compare with. Comparing the bytes is certain; another array may have the
/// same address and size.
template <class T>
class KeptCopy {
  public:
    /// Returns whether the values differ from the copy. If so, updates the copy.
    bool follow(std::span<const T> values)
    {
        const std::size_t bytes = values.size_bytes();
        if (kept_ && copy_.size() == values.size() &&
            (bytes == 0 || std::memcmp(copy_.data(), values.data(), bytes) == 0))
            return false;
        kept_ = false;
        copy_.resize(values.size());
        if (bytes > 0) std::memcpy(copy_.data(), values.data(), bytes);
        kept_ = true;
        return true;
    }

    /// Until keep(), the next call of follow() returns true whatever the values are.
    void forget() { kept_ = false; }
    void keep() { kept_ = true; }

  private:
    firsthit::Buffer<T> copy_;
    bool kept_ = false;
};

} // namespace firsthit::gl
