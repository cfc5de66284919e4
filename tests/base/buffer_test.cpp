// buffer_test.cpp - buffers keep their memory and grow when necessary.
#include "base/buffer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace firsthit {
namespace {

TEST(Buffer, IsAlignedToCacheLines)
{
    for (const std::size_t count : {1u, 3u, 64u, 1000u}) {
        Buffer<float> buffer;
        buffer.resize(count);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.data()) % 64, 0u);
    }
}

TEST(Buffer, KeepsItsMemoryAndContentWhenItShrinks)
{
    Buffer<int> buffer;
    buffer.resize(100);
    for (std::size_t k = 0; k < 100; ++k) buffer[k] = int(k);
    const int* const data = buffer.data();
    buffer.resize(10);
    EXPECT_EQ(buffer.size(), 10u);
    EXPECT_EQ(buffer.span().size(), 10u);
    buffer.resize(100);
    EXPECT_EQ(buffer.data(), data);
    EXPECT_EQ(buffer[99], 99);
}

TEST(Buffer, GrowsIntoWhatIsSpareWithoutMoving)
{
    Buffer<int> buffer;
    buffer.resize(100, 50);
    const int* const data = buffer.data();
    EXPECT_EQ(buffer.size(), 100u);
    buffer.resize(150);
    EXPECT_EQ(buffer.data(), data);
}

TEST(Buffer, StartsFilledWhereATestAskedForIt)
{
    fresh_fill = FreshFill::nan;
    Buffer<std::uint32_t> buffer;
    buffer.resize(100, 20);
    fresh_fill = FreshFill::none;
    for (const std::uint32_t word : buffer.span()) EXPECT_EQ(word, 0x7FC00000u);
    EXPECT_EQ(buffer.data()[119 + 16], 0x7FC00000u); // the room for a register's end too
    Buffer<std::uint64_t> bytes;
    fresh_fill = FreshFill::random;
    bytes.resize(2);
    buffer.resize(1000);
    fresh_fill = FreshFill::none;
    EXPECT_NE(bytes[0], bytes[1]);
    EXPECT_NE(bytes[0], (std::uint64_t(buffer[1]) << 32 | buffer[0]));
}

TEST(Buffer, IsEmptyAfterItCouldNotGrow)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers stop at such an allocation";
#endif
    const volatile std::size_t too_many = std::numeric_limits<std::size_t>::max() / 4;
    Buffer<char> buffer;
    buffer.resize(100);
    EXPECT_THROW(buffer.resize(too_many), std::bad_alloc);
    EXPECT_EQ(buffer.size(), 0u);
    buffer.resize(50);
    EXPECT_NE(buffer.data(), nullptr);
}

} // namespace
} // namespace firsthit
