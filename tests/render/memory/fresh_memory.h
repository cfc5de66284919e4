// fresh_memory.h - while it exists, new memory of buffers is filled with chosen values.
#pragma once

#include "base/fresh_memory.h"

#include <array>

namespace firsthit::test {

class FreshMemory {
  public:
    explicit FreshMemory(FreshFill fill) { fresh_fill = fill; }
    ~FreshMemory() { fresh_fill = FreshFill::none; }
    FreshMemory(const FreshMemory&) = delete;
    FreshMemory& operator=(const FreshMemory&) = delete;
};

inline constexpr std::array kFreshFills = {FreshFill::zeros, FreshFill::ones, FreshFill::nan,
    FreshFill::one, FreshFill::minus, FreshFill::random};

} // namespace firsthit::test
