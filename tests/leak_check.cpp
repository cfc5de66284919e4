// leak_check.cpp - looks for leaks at the end of a test program's tests, in builds for the address sanitizer.
//
// By itself the sanitizer looks when the process ends, while threads of OpenGL drivers end as well; it stops
// every thread to look, and gives up where one ends meanwhile. At the end of the tests they all rest, or have
// ended a moment ago.
#include <gtest/gtest.h>
#include <sanitizer/lsan_interface.h>

#include <chrono>
#include <thread>

namespace firsthit::test {
namespace {

class LeakCheck : public testing::Environment {
  public:
    void TearDown() override
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        __lsan_do_leak_check(); // and not once more when the process ends
    }
};

const testing::Environment* const leak_check = testing::AddGlobalTestEnvironment(new LeakCheck);

} // namespace
} // namespace firsthit::test
