// stored_depth.h - the precision and the range of stored depths, w = 1/t.
#pragma once

namespace firsthit {

/// Every stored w = 1/t has a relative error of at most kDepthError. Two w whose relative
/// difference is more than kDepthSlack are in the right order, since two errors and the roundings
/// of the comparison take less than 3.3 * 2^-20. Closer ones are compared exactly.
inline constexpr float kDepthError = 0x1.8p-20f;
inline constexpr float kDepthSlack = 0x1p-18f;

/// The largest w that is stored; it stands for all depths below 2^-120. It is far from overflow.
/// Two depths that are both stored as this are equal, and so they are compared exactly.
inline constexpr float kGreatestW = 0x1p120f;

} // namespace firsthit
