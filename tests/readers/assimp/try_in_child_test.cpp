// try_in_child_test.cpp - a crash in a child process is an error here.
#include "message_of.h"
#include "readers/assimp/try_in_child.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace firsthit {
namespace {

TEST(TryInChild, WorkThatEndsIsNoError)
{
    int calls = 0;
    EXPECT_NO_THROW(try_in_child("m.fbx", 10, [&] {
        ++calls;
        return true;
    }));
    EXPECT_EQ(calls, 0); // it was the child's
}

TEST(TryInChild, ACrashNamesTheFileAndTheSignal)
{
    const auto crash = [] {
        std::raise(SIGSEGV);
        return true;
    };
    EXPECT_EQ(message_of<FileError>([&] { try_in_child("m.fbx", 10, crash); }),
        "m.fbx: cannot be read: Assimp crashes on it (signal 11); is it damaged?");
    const auto abort = [] {
        std::fputs("not to be seen\n", stderr);
        std::abort();
        return true;
    };
    EXPECT_EQ(message_of<FileError>([&] { try_in_child("m.fbx", 10, abort); }),
        "m.fbx: cannot be read: Assimp crashes on it (signal 6); is it damaged?");
}

TEST(TryInChild, ALimitIsNamed)
{
    EXPECT_EQ(message_of<FileError>([] { try_in_child("m.fbx", 10, [] { return false; }); }),
        "m.fbx: cannot be read: it takes Assimp too much memory; is it damaged?");
    const auto slow = [] {
        std::raise(SIGXCPU);
        return true;
    };
    EXPECT_EQ(message_of<FileError>([&] { try_in_child("m.fbx", 5'000'000, slow); }),
        "m.fbx: cannot be read: it takes Assimp more than 30 s; is it damaged?");
}

} // namespace
} // namespace firsthit
