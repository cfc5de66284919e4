// cast_answers.h - what a traversal keeps of the triangles that a ray hits.
#pragma once

#include "exact/ray_hit.h"
#include "rays/tree/prepared_ray.h"
#include "rays/tree/ray_tree.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace firsthit {

/// A triangle that a ray hits, with an interval that contains its scaled t.
struct Candidate {
    const TriangleBlock* block = nullptr;
    int lane = 0;
    std::uint32_t triangle = kNoItem;
    float low = 0, high = std::numeric_limits<float>::infinity();

    Corners corners() const
    {
        Corners c;
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                c[std::size_t(corner)][axis] = block->corner[3 * corner + axis][lane];
        return c;
    }
};

/// Whether a is before b: by t, then by id.
inline bool is_before(const Ray& ray, const Candidate& a, const Candidate& b)
{
    if (a.high < b.low) return true;
    if (b.high < a.low) return false;
    Effort effort;
    const int order = compare_depth(ray, a.corners(), b.corners(), effort);
    return order != 0 ? order < 0 : a.triangle < b.triangle;
}

// An answer has
//   limit()          hits with a scaled t that is certainly greater are of no use
//   take(ray, hit)   is told of a hit; returns whether the ray is done

class NearestAnswer {
  public:
    float limit() const { return best_.high; }
    bool take(const Ray& ray, const Candidate& hit)
    {
        if (best_.block == nullptr || is_before(ray, hit, best_)) {
            const float high = std::min(best_.high, hit.high);
            best_ = hit;
            best_.high = high;
        } else {
            best_.high = std::min(best_.high, hit.high);
        }
        return false;
    }
    const Candidate& best() const { return best_; }

  private:
    Candidate best_; // without a block: none
};

class AnyAnswer {
  public:
    float limit() const { return std::numeric_limits<float>::infinity(); }
    bool take(const Ray&, const Candidate&) { return found_ = true; }
    bool found() const { return found_; }

  private:
    bool found_ = false;
};

class CountAnswer {
  public:
    float limit() const { return std::numeric_limits<float>::infinity(); }
    bool take(const Ray&, const Candidate&) { return ++count_, false; }
    std::uint32_t count() const { return count_; }

  private:
    std::uint32_t count_ = 0;
};

class AllAnswer {
  public:
    void clear() { hits_.clear(); }
    float limit() const { return std::numeric_limits<float>::infinity(); }
    bool take(const Ray&, const Candidate& hit) { return hits_.push_back(hit), false; }
    const std::vector<Candidate>& sorted(const Ray& ray)
    {
        std::sort(hits_.begin(), hits_.end(),
            [&](const Candidate& a, const Candidate& b) { return is_before(ray, a, b); });
        return hits_;
    }

  private:
    std::vector<Candidate> hits_;
};

} // namespace firsthit
