// process_owned.h - pointers to objects that a child process must not destroy after fork().
#pragma once

#include <unistd.h>

#include <memory>
#include <utility>

namespace firsthit {

/// Remembers the process that constructed it. After fork() the child has a copy of the memory but
/// none of the other threads, so a destructor that joins threads or waits for them would never
/// return.
class HomeProcess {
  public:
    bool is_this() const { return pid_ == getpid(); }

  private:
    pid_t pid_ = getpid();
};

/// Deleter that deletes an object only in the process that made the pointer, and leaks it in
/// others.
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

/// For objects that own threads, or library handles that own threads.
template <class T>
using ProcessOwned = std::unique_ptr<T, DeleteAtHome<T>>;

template <class T, class... Arguments>
ProcessOwned<T> make_process_owned(Arguments&&... arguments)
{
    return ProcessOwned<T>(new T(std::forward<Arguments>(arguments)...));
}

} // namespace firsthit
