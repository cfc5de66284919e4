// smooth_normals.cpp - normals for triangles that came without.
#include "scene/model/smooth_normals.h"

#include "base/buffer.h"
#include "base/large_pages.h"
#include "scene/model/corner_normal.h"

#include <glm/geometric.hpp>
#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

/// Points, or triangles, that one thread takes at once.
constexpr std::size_t kGrain = 1 << 12;

/// Points; far enough ahead for memory to answer.
constexpr std::size_t kAhead = 4;

/// The corners (3 * triangle + k) at each point, ascending.
struct CornersOfPoints {
    std::vector<std::uint32_t> first; // (points + 1) where those of each point begin
    Buffer<std::uint32_t> corner;
};

CornersOfPoints corners_of_points(std::span<const glm::uvec3> index, std::size_t points)
{
    CornersOfPoints of;
    // Counting sort; first[p + 1] is where the next corner of point p goes, and in the end its end.
    of.first.resize(points + 2);
    for (const glm::uvec3& corners : index)
        for (int k = 0; k < 3; ++k) ++of.first[corners[k] + 2];
    for (std::size_t p = 2; p < of.first.size(); ++p) of.first[p] += of.first[p - 1];
    of.corner.resize(index.size() * 3);
    std::uint32_t number = 0;
    for (const glm::uvec3& corners : index)
        for (int k = 0; k < 3; ++k) of.corner[of.first[corners[k] + 1]++] = number++;
    of.first.pop_back();
    return of;
}

/// What the edges of a triangle are compared by.
struct Facet {
    glm::dvec3 cross;
    double length; // of cross
};

/// An edge of a triangle at a point.
struct EdgeEnd {
    std::uint64_t key;   // the point at its other end, then the corner that the edge leaves from
    std::uint32_t local; // which of the point's corners the triangle has

    std::uint32_t other() const { return static_cast<std::uint32_t>(key >> 32); }
    bool operator<(const EdgeEnd& b) const { return key < b.key; }
};

/// The corners around one point, and the groups that they are in; kept from point to point.
class CornerGroups {
  public:
    CornerGroups(std::span<const glm::vec3> position, std::span<const glm::uvec3> index,
        std::span<const Facet> facet, double least_cosine, std::span<const std::uint32_t> group)
        : position_(position),
          index_(index),
          facet_(facet),
          least_cosine_(least_cosine),
          group_(group)
    {
    }

    /// Finds the groups of a point's corners.
    void find(std::span<const std::uint32_t> corner)
    {
        const std::size_t count = corner.size();
        if (parent_.size() < count) {
            leaving_.resize(count);
            arriving_.resize(count);
            parent_.resize(count);
            facet_of_.resize(count);
            ends_.resize(count);
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t triangle = corner[i] / 3;
            const std::uint32_t k = corner[i] - 3 * triangle;
            const std::uint32_t after = k == 2 ? 0 : k + 1;
            const std::uint32_t before = k == 0 ? 2 : k - 1;
            const glm::uvec3& ends = index_[triangle];
            parent_[i] = i;
            facet_of_[i] = &facet_[triangle];
            ends_[i] = {ends[int(after)], ends[int(before)]};
            insert({std::uint64_t(ends_[i].after) << 32 | corner[i], i}, leaving_, i);
            insert(
                {std::uint64_t(ends_[i].before) << 32 | (3 * triangle + before), i}, arriving_, i);
        }
        if (count > kInsertionSort) {
            std::sort(leaving_.begin(), leaving_.begin() + std::ptrdiff_t(count));
            std::sort(arriving_.begin(), arriving_.begin() + std::ptrdiff_t(count));
        }
        // Merge both lists, and join what follows one another at the same edge.
        const EdgeEnd* last = nullptr;
        for (std::size_t a = 0, b = 0; a + b < 2 * count;) {
            const bool leaves = b == count || (a < count && leaving_[a] < arriving_[b]);
            const EdgeEnd* const edge = leaves ? &leaving_[a++] : &arriving_[b++];
            if (last && last->other() == edge->other() && pass_into(last->local, edge->local))
                join(last->local, edge->local);
            last = edge;
        }
    }

    /// Prefetches what find() loads for a point that comes soon.
    void prefetch(std::span<const std::uint32_t> corner) const
    {
        for (const std::uint32_t c : corner) {
            hwy::Prefetch(&index_[c / 3]);
            hwy::Prefetch(&facet_[c / 3]);
        }
    }

    /// The first corner of a corner's group, both as numbers among the point's.
    std::uint32_t root(std::uint32_t i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    /// What corner_normal gives for a corner of the point, to the bit.
    glm::dvec3 normal(std::size_t point, std::size_t i) const
    {
        const glm::dvec3 p(position_[point]);
        const glm::dvec3 out = glm::dvec3(position_[ends_[i].after]) - p;
        const glm::dvec3 in = glm::dvec3(position_[ends_[i].before]) - p;
        const double lengths = glm::dot(out, out) * glm::dot(in, in);
        return lengths > 0 ? facet_of_[i]->cross / lengths : glm::dvec3(0);
    }

  private:
    static constexpr std::uint32_t kInsertionSort = 32; // corners; more are sorted otherwise

    static void insert(const EdgeEnd& edge, std::vector<EdgeEnd>& sorted, std::uint32_t place)
    {
        if (place < kInsertionSort)
            for (; place > 0 && edge < sorted[place - 1]; --place)
                sorted[place] = sorted[place - 1];
        sorted[place] = edge;
    }

    bool pass_into(std::uint32_t a, std::uint32_t b) const
    {
        const double lengths = facet_of_[a]->length * facet_of_[b]->length;
        if (!group_.empty()) {
            const std::uint32_t one = group_of(a), other = group_of(b);
            if (one != other || one == 0) return false;
            if (one != kNoSmoothingGroup) return lengths > 0;
        }
        return lengths > 0 &&
               glm::dot(facet_of_[a]->cross, facet_of_[b]->cross) >= least_cosine_ * lengths;
    }

    std::uint32_t group_of(std::uint32_t i) const
    {
        return group_[static_cast<std::size_t>(facet_of_[i] - facet_.data())];
    }

    /// The lower number becomes the root, so that the result does not depend on the order.
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

    /// The points at the other ends of a corner's edges.
    struct Ends {
        std::uint32_t after, before;
    };

    std::span<const glm::vec3> position_;
    std::span<const glm::uvec3> index_;
    std::span<const Facet> facet_;
    double least_cosine_;
    std::span<const std::uint32_t> group_;    // (T) or empty
    std::vector<EdgeEnd> leaving_, arriving_; // sorted
    std::vector<std::uint32_t> parent_;
    std::vector<const Facet*> facet_of_;
    std::vector<Ends> ends_;
};

Buffer<Facet> facets(
    std::span<const glm::vec3> position, std::span<const glm::uvec3> index, Tasks& tasks)
{
    Buffer<Facet> facet;
    facet.resize(index.size());
    tasks.for_ranges(index.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t) {
            facet[t].cross = triangle_edges(position, index[t]).cross;
            facet[t].length = glm::length(facet[t].cross);
        }
    });
    return facet;
}

/// Sums the normals around each point.
class NormalMaker {
  public:
    NormalMaker(
        std::span<const glm::vec3> position, std::span<const glm::uvec3> index, Tasks& tasks)
        : position_(position),
          index_(index),
          of_(corners_of_points(index, position.size())),
          tasks_(tasks)
    {
    }

    SmoothNormals all_smooth()
    {
        SmoothNormals made;
        made.normal.resize(position_.size());
        resize_in_large_pages(made.corner, 3 * index_.size());
        tasks_.for_ranges(position_.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t p = first; p < last; ++p) {
                glm::dvec3 sum(0);
                for (const std::uint32_t corner : corners_at(p)) {
                    sum += normal_at(corner);
                    made.corner[corner] = static_cast<std::uint32_t>(p);
                }
                made.normal[p] = unit_normal(sum);
            }
        });
        return made;
    }

    SmoothNormals with_creases(double crease_angle_rad, std::span<const std::uint32_t> group)
    {
        const Buffer<Facet> facet = facets(position_, index_, tasks_);
        const double least_cosine = std::cos(crease_angle_rad);
        const std::size_t ranges = (position_.size() + kGrain - 1) / kGrain;

        // Number the normals of each range of points from 0, and of all points when all are known.
        SmoothNormals made;
        resize_in_large_pages(made.corner, 3 * index_.size());
        std::vector<std::vector<glm::vec3>> normal(ranges);
        tasks_.for_ranges(position_.size(), kGrain, [&](std::size_t first, std::size_t last) {
            CornerGroups groups(position_, index_, facet.span(), least_cosine, group);
            std::vector<glm::vec3>& normals = normal[first / kGrain];
            std::vector<glm::dvec3> sum;
            for (std::size_t p = first; p < last; ++p) {
                const std::span<const std::uint32_t> corner = corners_at(p);
                groups.find(corner);
                if (p + kAhead < last) groups.prefetch(corners_at(p + kAhead));
                sum.clear();
                const auto before = static_cast<std::uint32_t>(normals.size());
                for (std::uint32_t i = 0; i < corner.size(); ++i) {
                    const std::uint32_t root = groups.root(i);
                    const std::uint32_t number =
                        root == i ? before + static_cast<std::uint32_t>(sum.size())
                                  : made.corner[corner[root]];
                    if (root == i) sum.emplace_back(0);
                    made.corner[corner[i]] = number;
                    sum[number - before] += groups.normal(p, i);
                }
                for (const glm::dvec3& s : sum) normals.push_back(unit_normal(s));
            }
        });
        std::vector<std::uint32_t> start(ranges + 1);
        for (std::size_t r = 0; r < ranges; ++r)
            start[r + 1] = start[r] + static_cast<std::uint32_t>(normal[r].size());
        made.normal.resize(start[ranges]);
        tasks_.for_each(ranges, [&](std::size_t r, std::size_t) {
            std::copy(normal[r].begin(), normal[r].end(), made.normal.begin() + start[r]);
        });
        tasks_.for_ranges(index_.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t t = first; t < last; ++t)
                for (int k = 0; k < 3; ++k)
                    made.corner[3 * t + std::size_t(k)] += start[index_[t][k] / kGrain];
        });
        return made;
    }

  private:
    std::span<const std::uint32_t> corners_at(std::size_t point) const
    {
        return of_.corner.span().subspan(of_.first[point], of_.first[point + 1] - of_.first[point]);
    }

    glm::dvec3 normal_at(std::uint32_t corner) const
    {
        return corner_normal(
            triangle_edges(position_, index_[corner / 3]), static_cast<int>(corner % 3));
    }

    std::span<const glm::vec3> position_;
    std::span<const glm::uvec3> index_;
    CornersOfPoints of_;
    Tasks& tasks_;
};

} // namespace

SmoothNormals smooth_normals(std::span<const glm::vec3> position, std::span<const glm::uvec3> index,
    double crease_angle_rad, Tasks& tasks, std::span<const std::uint32_t> group)
{
    NormalMaker maker(position, index, tasks);
    // Written so that an angle that is no number is smooth too.
    const bool smooth = !(crease_angle_rad < std::numbers::pi);
    if (smooth && group.empty()) return maker.all_smooth();
    return maker.with_creases(smooth ? std::numbers::pi : std::max(0.0, crease_angle_rad), group);
}

SmoothNormals smooth_normals(
    std::span<const glm::vec3> position, std::span<const glm::uvec3> index, double crease_angle_rad)
{
    Tasks one(1);
    return smooth_normals(position, index, crease_angle_rad, one);
}

} // namespace firsthit
