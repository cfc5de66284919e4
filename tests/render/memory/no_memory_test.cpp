// no_memory_test.cpp - frames that run out of memory. A separate program, because its operator new
// refuses large blocks when it is told to.
#include "message_of.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> limit{~std::size_t(0)}; // bytes of one block

/// A whole number of alignments.
std::size_t padded(std::size_t bytes, std::size_t alignment)
{
    return (bytes + alignment - 1) / alignment * alignment;
}

void* allocated(std::size_t bytes, std::size_t alignment)
{
    void* const memory =
        bytes <= limit ? std::aligned_alloc(alignment, padded(bytes, alignment)) : nullptr;
    if (!memory) throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t bytes)
{
    return allocated(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    return allocated(bytes, std::size_t(alignment));
}
// The pairs match, but GCC sees the one through the other where it inlines only one of them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

// Drivers use these functions, so they must use the same allocator.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
    return std::aligned_alloc(alignof(std::max_align_t), padded(bytes, alignof(std::max_align_t)));
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
    return std::aligned_alloc(std::size_t(alignment), padded(bytes, std::size_t(alignment)));
}
void operator delete(void* memory) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    std::free(memory);
}

namespace firsthit::test {
namespace {

TEST(NoMemory, GivesUpAHybridFrameThatOpenGlStillDraws)
{
    const Scene scene = load_scene("builtin:robots");
    View view;
    view.width = view.height = 32;
    Settings settings;
    settings.engine = Engine::hybrid;
    Film film;
    Renderer renderer(2);
    try {
        renderer.render(scene, 2, view, settings, film);
    } catch (const DeviceError& error) {
        GTEST_SKIP() << error.what();
    }
    view.width = view.height = 1024;
    settings.shadows = Shadows::none; // the film gets its size, and no hits are kept
    renderer.render(scene, 2, view, settings, film);
    const Film expected = film;

    settings.shadows = Shadows::map;
    limit = 1 << 20;
    EXPECT_EQ(message_of<Error>([&] { renderer.render(scene, 2, view, settings, film); }),
        "not enough memory for a picture of this size");
    limit = ~std::size_t(0);
    settings.engine = Engine::gpu; // another frame may have the context at once
    EXPECT_NO_THROW(renderer.render(scene, 2, view, settings, film));
    settings.engine = Engine::hybrid;
    settings.shadows = Shadows::none;
    renderer.render(scene, 2, view, settings, film);
    EXPECT_EQ(film.color.value, expected.color.value);

    Renderer other(2); // is deleted after it has failed
    other.render(scene, 2, view, settings, film);
    settings.shadows = Shadows::map;
    limit = 1 << 20;
    EXPECT_THROW(other.render(scene, 2, view, settings, film), Error);
    limit = ~std::size_t(0);
}

} // namespace
} // namespace firsthit::test
