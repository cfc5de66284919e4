// kept_copy.h - have these bytes changed since they were last looked at?
#pragma once

#include "base/buffer.h"

#include <cstring>
#include <span>

namespace firsthit::gl {

/// A copy of an array: comparing is certain, where addresses and sizes may come again.
template <class T>
class KeptCopy {
  public:
    /// Whether the values are new; then they are copied.
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

    /// The next look says that they have changed, until keep().
    void forget() { kept_ = false; }
    void keep() { kept_ = true; }

  private:
    firsthit::Buffer<T> copy_;
    bool kept_ = false;
};

} // namespace firsthit::gl
