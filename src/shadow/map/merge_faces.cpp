// merge_faces.cpp - uses one map instead of several where a single face can see all hits.
#include "shadow/map/merge_faces.h"

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// Projects the rectangle of face `from` onto another face and adds it to `bounds`. Projecting the
/// corners is enough, since the rectangle's cone is convex. False if a corner is beyond
/// kWidestTangent.
bool add_projected_rectangle(int face, int from, const FaceBounds& from_bounds, FaceBounds& bounds)
{
    const FaceAxes to_axes = face_axes(face), axes = face_axes(from);
    for (int corner = 0; corner < 4; ++corner) {
        double p[3];
        p[axes.x] = corner & 1 ? double(from_bounds.x1) : double(from_bounds.x0);
        p[axes.y] = corner & 2 ? double(from_bounds.y1) : double(from_bounds.y0);
        p[axes.z] = axes.backwards ? -1 : 1;
        const double z = to_axes.backwards ? -p[to_axes.z] : p[to_axes.z];
        // With a tolerance that is larger than the rounding errors of the bounds.
        const double limit = kWidestTangent * z * (1 + 0x1p-20);
        if (!(z > 0 && std::abs(p[to_axes.x]) <= limit && std::abs(p[to_axes.y]) <= limit))
            return false;
        const float x = float(p[to_axes.x] / z), y = float(p[to_axes.y] / z);
        bounds.add({x, y, x, y, 0});
    }
    return true;
}

} // namespace

void merge_faces(LightBounds& bounds)
{
    const auto used = [](const FaceBounds& face) { return face.hits > 0; };
    if (std::count_if(bounds.begin(), bounds.end(), used) < 2) return;
    FaceBounds smallest;
    double smallest_area = -1;
    int chosen = 0;
    for (int face = 0; face < kFaces; ++face) {
        FaceBounds all;
        bool seen = true;
        for (int from = 0; from < kFaces && seen; ++from) {
            const FaceBounds& other = bounds[std::size_t(from)];
            if (other.hits == 0) continue;
            seen = add_projected_rectangle(face, from, other, all);
            all.hits += other.hits;
        }
        const double area = (double(all.x1) - double(all.x0)) * (double(all.y1) - double(all.y0));
        if (!seen || (smallest_area >= 0 && area >= smallest_area)) continue;
        smallest = all;
        smallest_area = area;
        chosen = face;
    }
    if (smallest_area < 0) return;
    bounds = {};
    bounds[std::size_t(chosen)] = smallest;
}

} // namespace firsthit
