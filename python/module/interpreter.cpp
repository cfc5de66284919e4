// interpreter.cpp - the interpreter's lock (GIL), let go and taken so that the interpreter can end at any moment.
#include "interpreter.h"

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace firsthit::python {
namespace {

namespace py = pybind11;
using namespace std::chrono_literals;

std::atomic<bool> ending{false};
std::atomic<int> at_work{0}; // threads that work without the lock
std::atomic<int> locking{0}; // threads that wait for it, or have taken it for a while

[[noreturn]] void stop_for_good()
{
    for (;;) std::this_thread::sleep_for(1h);
}

/// Takes part in `locking`, unless the interpreter ends.
bool begin_locking()
{
    ++locking;
    if (!ending) return true;
    --locking;
    return false;
}

/// Called by the interpreter before it ends, with the lock.
void end_all()
{
    ending = true;
    const py::gil_scoped_release release;
    // Who waits for the lock gets it first. Frames are given up between two tiles; a function of the user's that does not
    // come back is not waited for.
    for (int k = 0; k < 10'000 && (locking > 0 || at_work > 0); ++k)
        std::this_thread::sleep_for(1ms);
}

} // namespace

Unlocked::Unlocked()
{
    if (ending) {
        PyEval_SaveThread();
        stop_for_good();
    }
    ++at_work;
    state_ = PyEval_SaveThread();
}

Unlocked::~Unlocked()
{
    if (!begin_locking()) {
        --at_work;
        stop_for_good();
    }
    PyEval_RestoreThread(state_);
    --at_work;
    --locking;
}

Locked::Locked()
{
    if (!begin_locking()) throw Ending();
    state_ = PyGILState_Ensure();
}

Locked::~Locked()
{
    PyGILState_Release(state_);
    --locking;
}

void check_ending()
{
    if (ending) throw Ending();
}

void add_ending(py::module_&)
{
    // A child that is forked has one thread, which is not here.
    pthread_atfork(nullptr, nullptr, [] { at_work = locking = 0; });
    py::module_::import("atexit").attr("register")(py::cpp_function(end_all));
}

} // namespace firsthit::python
