// buffer.h - memory that is kept from frame to frame: grows, never shrinks, starts undefined.
#pragma once

#include "base/large_pages.h"

#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

namespace firsthit {

/// What memory a buffer is made of.
enum class Pages {
    large, // of large arrays: they are written from end to end
    small, // room for the worst case, of which little is touched
};

/// An array of trivial elements, aligned to 64 bytes. Fresh memory is not touched, so what is
/// reserved and never used costs address space only.
template <class T, Pages pages = Pages::large>
class Buffer {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

  public:
    /// Room for count elements; the content is undefined where it had to grow. `spare` more are
    /// reserved when it grows, so that slowly growing needs allocate seldom.
    /// throws  std::bad_alloc; then it is empty
    void resize(std::size_t count, std::size_t spare = 0)
    {
        if (count > capacity_) {
            data_.reset();
            size_ = capacity_ = 0; // in case there is no memory
            const std::size_t bytes = (count + spare) * sizeof(T) + 64; // room for a register's end
            data_.reset(static_cast<T*>(::operator new(bytes, kAlignment)));
            if constexpr (pages == Pages::large) request_large_pages(data_.get(), bytes);
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
