// overlap_table.h - finds which of up to 64 boxes a triangle's box may overlap, by five table
// lookups instead of 64 tests.
//
// Each axis (x, y and depth w) is cut into 32 slots. For each slot, bit masks tell which boxes
// begin at or before it and which end at or after it; the boxes that overlap an interval on all
// axes are the `and` of five masks.
#pragma once

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace firsthit {

inline constexpr int kSlots = 32;      // slots of an axis
inline constexpr int kTableBoxes = 64; // boxes of a table: a bit each

/// Maps a coordinate to a slot, monotonically. Coordinates outside of [low, high] go to the first
/// or the last slot.
struct Slots {
    float start = 0, scale = 0;

    Slots(float low, float high) : start(low)
    {
        const float slots = float(kSlots) / (high - low);
        if (std::isfinite(slots) && std::isfinite(low)) scale = slots;
    }
    int of(float v) const
    {
        const float slot = (v - start) * scale;
        return slot > 0 ? int(std::min(slot, float(kSlots - 1))) : 0; // 0 for NaN
    }
};

/// Maps boxes and depths inside some bounds to slots.
struct BoxSlots {
    Slots x, y, w;

    explicit BoxSlots(const SampleBounds& all)
        : x(all.x0, all.x1),
          y(all.y0, all.y1),
          w(all.farthest_w, all.nearest_w)
    {
    }
};

/// A triangle's slots, of x0, y0, x1, y1 and nearest_w.
struct TriangleSlots {
    std::uint8_t slot[5];

    TriangleSlots() = default;
    TriangleSlots(const ProjectedTriangle& box, const BoxSlots& slots)
        : slot{std::uint8_t(slots.x.of(box.x0)), std::uint8_t(slots.y.of(box.y0)),
              std::uint8_t(slots.x.of(box.x1)), std::uint8_t(slots.y.of(box.y1)),
              std::uint8_t(slots.w.of(box.nearest_w))}
    {
    }
};

/// Up to 64 boxes, a bit each. Call add for each box, then finish once, then of as often as needed.
class OverlapTable {
  public:
    void add(int number, const SampleBounds& box, const BoxSlots& slots)
    {
        const int at[5] = {slots.x.of(box.x0), slots.x.of(box.x1), slots.y.of(box.y0),
            slots.y.of(box.y1), slots.w.of(box.farthest_w)};
        add(number, at);
    }

    /// number  of the box, 0 to 63
    /// slot    of x0, x1, y0, y1 and the farthest w
    void add(int number, const int (&slot)[5])
    {
        const std::uint64_t bit = std::uint64_t(1) << number;
        from_x_[slot[0]] |= bit;
        to_x_[slot[1]] |= bit;
        from_y_[slot[2]] |= bit;
        to_y_[slot[3]] |= bit;
        behind_[slot[4]] |= bit;
        open |= bit;
    }

    /// Completes the masks after the last add.
    void finish()
    {
        for (int k = 1; k < kSlots; ++k) {
            from_x_[k] |= from_x_[k - 1];
            from_y_[k] |= from_y_[k - 1];
            behind_[k] |= behind_[k - 1];
        }
        for (int k = kSlots - 2; k >= 0; --k) {
            to_x_[k] |= to_x_[k + 1];
            to_y_[k] |= to_y_[k + 1];
        }
    }

    /// The open boxes that the triangle may overlap in x and y without being behind all their
    /// samples. A box that it does overlap is never left out.
    std::uint64_t of(const TriangleSlots& s) const
    {
        return from_x_[s.slot[2]] & to_x_[s.slot[0]] & from_y_[s.slot[3]] & to_y_[s.slot[1]] &
               behind_[s.slot[4]] & open;
    }

    std::uint64_t open = 0; // boxes that `of` may return; the caller clears bits of finished ones

  private:
    std::uint64_t from_x_[kSlots] = {}; // boxes whose first slot is at most this one
    std::uint64_t to_x_[kSlots] = {};   // boxes whose last slot is at least this one
    std::uint64_t from_y_[kSlots] = {};
    std::uint64_t to_y_[kSlots] = {};
    std::uint64_t behind_[kSlots] = {}; // boxes whose farthest sample is in this slot or farther
};

} // namespace firsthit
