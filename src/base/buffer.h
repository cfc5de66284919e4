// buffer.h - an array that is kept from frame to frame: grows, never shrinks, is not initialised.
#pragma once

#include "base/fresh_memory.h"
#include "base/large_pages.h"

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace firsthit {

/// The page size of a buffer's memory.
enum class Pages {
    large, // for large arrays that are written from end to end
    small, // for worst-case reservations of which little is touched
};

/// An array of trivial elements, aligned to 64 bytes. New memory is not written, so reserved memory
/// that is never used costs only address space. A register of up to 64 bytes may be read or written
/// from any element on: there are 64 spare bytes behind the last element.
template <class T, Pages pages = Pages::large>
class Buffer {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    /// Sets the size. If the buffer has to grow, its content becomes undefined, and `spare` more
    /// elements are reserved, so that a slowly growing size allocates seldom.
    /// throws  std::bad_alloc; the buffer is empty then
    void resize(std::size_t count, std::size_t spare = 0)
    {
        if (count > capacity_) {
            data_.reset();
            size_ = capacity_ = 0; // stays so if the allocation throws
            const std::size_t bytes = (count + spare) * sizeof(T) + 64; // spare bytes, see above
            data_.reset(static_cast<T*>(::operator new(bytes, kAlignment)));
            if constexpr (pages == Pages::large) request_large_pages(data_.get(), bytes);
            fill_fresh(data_.get(), bytes);
            capacity_ = count + spare;
        }
        size_ = count;
    }

    T* data() { return data_.get(); }
    const T* data() const { return data_.get(); }
    std::size_t size() const { return size_; }
    T& operator[](std::size_t i) { return data_.get()[i]; }
    const T& operator[](std::size_t i) const { return data_.get()[i]; }
    std::span<T> span() { return {data(), size_}; }
    std::span<const T> span() const { return {data(), size_}; }

  private:
    static constexpr std::align_val_t kAlignment{64};
    struct Free {
        void operator()(T* memory) const { ::operator delete(memory, kAlignment); }
    };
    std::unique_ptr<T[], Free> data_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

} // namespace firsthit
