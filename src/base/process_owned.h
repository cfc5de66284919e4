// process_owned.h - what a child process must not destroy after fork().
#pragma once

#include <unistd.h>

#include <memory>
#include <utility>

namespace firsthit {

/// The process that made this. A child after fork() has a copy of the memory, but none of the
/// threads: whoever joins them, or waits for what they should do, waits forever.
class HomeProcess {
  public:
    bool is_this() const { return pid_ == getpid(); }

  private:
    pid_t pid_ = getpid();
};

/// Deletes an object in the process that made the pointer, and leaks it in every other.
template <class T>
class DeleteAtHome {
  public:
    bool is_home() const { return home_.is_this(); }
    void operator()(T* object) const
    {
        if (is_home()) delete object;
    }

  private:
    HomeProcess home_;
};

/// For objects that own threads, or handles of libraries that do.
template <class T>
using ProcessOwned = std::unique_ptr<T, DeleteAtHome<T>>;

template <class T, class... Arguments>
ProcessOwned<T> make_process_owned(Arguments&&... arguments)
{
    return ProcessOwned<T>(new T(std::forward<Arguments>(arguments)...));
}

} // namespace firsthit
