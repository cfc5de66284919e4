// byte_table.h - a number for each byte, as byte_table-inl.h looks it up.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace firsthit {

struct ByteTable {
    alignas(64) std::array<float, 256> value;
    // The halves of its bits: 32 of them are a register, and an instruction looks up in two.
    alignas(64) std::array<std::uint16_t, 256> high;
    alignas(64) std::array<std::uint16_t, 256> low;

    explicit ByteTable(const std::array<float, 256>& values) : value(values)
    {
        for (std::size_t byte = 0; byte < value.size(); ++byte) {
            const auto bits = std::bit_cast<std::uint32_t>(value[byte]);
            high[byte] = static_cast<std::uint16_t>(bits >> 16);
            low[byte] = static_cast<std::uint16_t>(bits);
        }
    }
};

} // namespace firsthit
