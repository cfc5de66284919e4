// interpreter.h - the interpreter's lock (GIL), let go and taken so that the interpreter can end at any moment.
//
// When the interpreter ends, it ends every thread that waits for the lock, by unwinding its stack, and C++ ends the
// process at the first destructor on the way. So a thread that is here then never asks for the lock again: it stops for
// good, and the end waits for it until then.
#pragma once

#include <pybind11/pybind11.h>

namespace firsthit::python {

/// Lets the lock go while it exists. The end of the interpreter stops the thread in the destructor.
class Unlocked {
  public:
    Unlocked();
    ~Unlocked();
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

  private:
    PyThreadState* state_;
};

/// Takes the lock while it exists, within an Unlocked.
class Locked {
  public:
    /// throws  Ending
    Locked();
    ~Locked();
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;

  private:
    PyGILState_STATE state_;
};

/// Thrown by work without the lock to get to the Unlocked around it when the interpreter ends.
struct Ending {};

/// throws  Ending: the interpreter ends
void check_ending();

/// Has the end of the interpreter wait for what is at work here.
void add_ending(pybind11::module_& module);

} // namespace firsthit::python
