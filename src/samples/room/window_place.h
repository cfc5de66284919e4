// window_place.h - where the window is, which walls and what hangs in it share.
#pragma once

namespace firsthit {

/// The hole in the wall at x = -3, metres.
struct WindowPlace {
    double low_z = -1.45;
    double high_z = 0.55;
    double sill = 0.80;
    double head = 2.25;

    double middle_z() const { return 0.5 * (low_z + high_z); }
    double half_z() const { return 0.5 * (high_z - low_z); }
};

inline WindowPlace window_place()
{
    return {};
}

} // namespace firsthit
