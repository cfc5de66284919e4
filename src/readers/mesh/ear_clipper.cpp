// ear_clipper.cpp - cuts a polygon of the plane into triangles, an ear at a time.
#include "readers/mesh/ear_clipper.h"

#include "readers/mesh/point_tree.h"
#include "readers/mesh/turn.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

/// Steps of searching for each corner of the polygon: outlines that do not cross themselves need
/// some dozens, or half as many as the root of n.
constexpr std::size_t kWorkPerCorner = 192;

/// How often all corners are looked at again when no ear is left, which crossing outlines need.
constexpr int kMaxRounds = 4;

/// How many corners are looked at for a convex one when all that is left crosses itself.
constexpr int kMaxSteps = 64;

/// A list that is taken from at its front.
class Queue {
  public:
    void push(std::uint32_t corner) { corners_.push_back(corner); }
    bool empty() const { return front_ == corners_.size(); }
    std::uint32_t pop() { return corners_[front_++]; }

  private:
    std::vector<std::uint32_t> corners_;
    std::size_t front_ = 0;
};

class EarClipper {
  public:
    explicit EarClipper(std::span<const glm::dvec2> point)
        : point_(point),
          corners_(point.size()),
          left_(point.size()),
          work_left_(kWorkPerCorner * point.size()),
          hollow_(point, hollow_corners(point))
    {
        const auto n = static_cast<std::uint32_t>(point.size());
        for (std::uint32_t k = 0; k < n; ++k)
            corners_[k] = {.previous = k > 0 ? k - 1 : n - 1, .next = k + 1 < n ? k + 1 : 0};
    }

    bool run(std::vector<glm::uvec3>& triangles)
    {
        consider_all();
        for (; left_ > 3; --left_) {
            const std::uint32_t corner = choose();
            const auto [previous, next, is_ear, is_left] = corners_[corner];
            triangles.emplace_back(previous, corner, next);
            corners_[corner].is_left = false;
            corners_[previous].next = next;
            corners_[next].previous = previous;
            at_ = next;
            consider(previous);
            consider(next);
        }
        const Corner& last = corners_[at_];
        triangles.emplace_back(last.previous, at_, last.next);
        return !crosses_ && turn_at(at_) >= 0;
    }

  private:
    struct Corner {
        std::uint32_t previous = 0;
        std::uint32_t next = 0;
        bool is_ear = false;
        bool is_left = true; // not cut off
    };

    /// Corners that are not convex: only they can lie in a triangle of others. Cutting off ears makes
    /// none.
    static std::vector<std::uint32_t> hollow_corners(std::span<const glm::dvec2> point)
    {
        std::vector<std::uint32_t> hollow;
        const std::size_t n = point.size();
        for (std::size_t k = 0; k < n; ++k)
            if (turn(point[k > 0 ? k - 1 : n - 1], point[k], point[k + 1 < n ? k + 1 : 0]) <= 0)
                hollow.push_back(static_cast<std::uint32_t>(k));
        return hollow;
    }

    int turn_at(std::uint32_t corner) const
    {
        const Corner& c = corners_[corner];
        return turn(point_[c.previous], point_[corner], point_[c.next]);
    }

    /// Whether the outline comes back from a corner the way it came, or stays at its point.
    bool is_spike(std::uint32_t corner) const
    {
        const Corner& c = corners_[corner];
        const glm::dvec2 before = point_[c.previous] - point_[corner];
        const glm::dvec2 after = point_[c.next] - point_[corner];
        if (before == glm::dvec2(0) || after == glm::dvec2(0)) return true;
        const int axis = std::abs(before.x) > std::abs(before.y) ? 0 : 1;
        return turn_at(corner) == 0 && (before[axis] > 0) == (after[axis] > 0);
    }

    /// Finds out anew what a corner is whose neighbours changed.
    void consider(std::uint32_t corner)
    {
        const int way = turn_at(corner);
        corners_[corner].is_ear = way > 0 && !is_blocked(corner);
        if (corners_[corner].is_ear)
            ears_.push(corner);
        else if (way == 0 && is_spike(corner))
            spikes_.push(corner);
    }

    void consider_all()
    {
        std::uint32_t corner = at_;
        for (std::size_t k = 0; k < left_; ++k, corner = corners_[corner].next) consider(corner);
    }

    /// The corner to cut off next.
    std::uint32_t choose()
    {
        for (bool again = true;; again = false) {
            // Spikes first: an ear below one would be covered twice.
            while (!spikes_.empty()) {
                const std::uint32_t corner = spikes_.pop();
                if (corners_[corner].is_left && is_spike(corner)) return corner;
            }
            while (!ears_.empty()) {
                const std::uint32_t corner = ears_.pop();
                if (corners_[corner].is_left && corners_[corner].is_ear) return corner;
            }
            if (!again || rounds_ == kMaxRounds) break;
            ++rounds_;
            consider_all();
        }
        crosses_ = true;
        for (int k = 0; k < kMaxSteps && turn_at(at_) < 0; ++k) at_ = corners_[at_].next;
        return at_;
    }

    /// Whether the outline goes through the inside of a convex corner's triangle.
    bool is_blocked(std::uint32_t corner)
    {
        if (work_left_ == 0) return true;
        const Corner& c = corners_[corner];
        const std::array<glm::dvec2, 3> triangle{
            point_[c.previous], point_[corner], point_[c.next]};
        std::size_t work = 0;
        const bool blocked = hollow_.any_near(triangle, work, [&](std::uint32_t other) {
            return other != corner && other != c.previous && other != c.next &&
                   corners_[other].is_left && enters(other, triangle);
        });
        work_left_ -= work < work_left_ ? work : work_left_;
        return blocked;
    }

    /// Whether a corner lies inside a triangle, or on its border with an edge that leads inside.
    bool enters(std::uint32_t corner, const std::array<glm::dvec2, 3>& triangle) const
    {
        std::array<bool, 3> on_side{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int way = turn(triangle[k], triangle[(k + 1) % 3], point_[corner]);
            if (way < 0) return false;
            on_side[k] = way == 0;
        }
        const auto leads_inside = [&](std::uint32_t end) {
            for (std::size_t k = 0; k < 3; ++k)
                if (on_side[k] && turn(triangle[k], triangle[(k + 1) % 3], point_[end]) <= 0)
                    return false;
            return true;
        };
        return leads_inside(corners_[corner].previous) || leads_inside(corners_[corner].next);
    }

    std::span<const glm::dvec2> point_;
    std::vector<Corner> corners_;
    std::size_t left_; // corners that are not cut off
    std::size_t work_left_;
    PointTree hollow_;
    Queue ears_;
    Queue spikes_;
    std::uint32_t at_ = 0; // a corner that is left
    int rounds_ = 0;
    bool crosses_ = false;
};

} // namespace

bool clip_ears(std::span<const glm::dvec2> point, std::vector<glm::uvec3>& triangles)
{
    return EarClipper(point).run(triangles);
}

} // namespace firsthit
