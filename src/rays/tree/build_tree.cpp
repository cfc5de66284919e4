// build_tree.cpp - the topology of a RayTree: ranges of triangles are split by binned surface areas.
#include "rays/tree/build_tree.h"

#include "exact/hit.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <limits>

namespace firsthit {
namespace {

using glm::vec3;

constexpr int kBins = 32;
/// Below this depth ranges are halved, so that no tree is deeper than kDeepest.
constexpr int kDeepByArea = 48;
static_assert(kDeepByArea + 32 <= kDeepest);
/// A leaf is split only if that lowers its cost to less than this share: half-empty leaves fill the caches.
constexpr double kWorthSplitting = 0.7;

struct TreeBox {
    vec3 low{std::numeric_limits<float>::infinity()}, high{-low};

    void add(const vec3& p)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void add(const TreeBox& other)
    {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// Half the surface; 0 of an empty box. In double: coordinates go up to 1e30.
    double area() const
    {
        const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low);
        return size.x >= 0 ? size.x * size.y + size.y * size.z + size.z * size.x : 0;
    }
};

struct Reference {
    TreeBox box;
    vec3 middle; // finite
    std::uint32_t triangle;
};

struct Range {
    std::size_t first, last; // of the references
    TreeBox box;
    bool is_splittable = true;

    std::size_t count() const { return last - first; }
};

/// The cost of a leaf: triangles are tested together, but fewer have smaller boxes.
double leaf_cost(double area, std::size_t count)
{
    return area * double((count + kPerLeaf - 1) / kPerLeaf);
}

struct Split {
    int axis = -1; // none: by the middle
    int bin = 0;   // bins below it go to the left
    double cost = std::numeric_limits<double>::infinity();
};

class TreeBuilder {
  public:
    explicit TreeBuilder(const WorldTriangles& triangles)
    {
        reference_.reserve(triangles.index.size());
        for (std::size_t t = 0; t < triangles.index.size(); ++t) {
            const glm::uvec3& c = triangles.index[t];
            Reference r;
            r.triangle = std::uint32_t(t);
            const Corners corners{
                triangles.position[c.x], triangles.position[c.y], triangles.position[c.z]};
            if (usable(corners))
                for (const vec3& p : corners) r.box.add(p);
            else
                r.box.add(vec3(0)); // its place may be anywhere
            r.middle = 0.5f * r.box.low + 0.5f * r.box.high;
            reference_.push_back(r);
        }
    }

    TreeTopology build()
    {
        if (reference_.empty()) return {};
        Range all{0, reference_.size(), {}};
        for (const Reference& r : reference_) all.box.add(r.box);
        build_node(all, 0);
        return std::move(topology_);
    }

  private:
    void build_node(const Range& range, int depth)
    {
        const std::size_t node = topology_.node.size();
        topology_.node.emplace_back();
        std::vector<Range> part = {range};
        while (part.size() < kWide) {
            const auto widest = std::max_element(part.begin(), part.end(),
                [](const Range& a, const Range& b) { return rank(a) < rank(b); });
            if (rank(*widest) < 0) break;
            Range right{};
            if (split(*widest, right, depth))
                part.push_back(right);
            else
                widest->is_splittable = false;
        }
        for (std::size_t k = 0; k < part.size(); ++k) {
            const bool leaf = part[k].count() <= kPerLeaf;
            const std::uint32_t index =
                std::uint32_t(leaf ? topology_.order.size() / kPerLeaf : topology_.node.size());
            topology_.node[node].child[k].value = leaf ? index | TreeChild::kLeaf : index;
            if (leaf)
                add_leaf(part[k]);
            else
                build_node(part[k], depth + 1);
        }
    }

    /// Which part to split next: the one with the largest box, of those that are too many for a leaf if there are
    /// such. The factor is beyond any ratio of areas that matters.
    static double rank(const Range& range)
    {
        if (!range.is_splittable || range.count() <= 1) return -1;
        return range.box.area() * (range.count() > kPerLeaf ? 1e60 : 1);
    }

    void add_leaf(const Range& range)
    {
        for (std::size_t k = 0; k < kPerLeaf; ++k)
            topology_.order.push_back(
                k < range.count() ? reference_[range.first + k].triangle : kNoItem);
    }

    /// Splits a range in two, of which it becomes the left one.
    /// returns  false where a leaf is better
    bool split(Range& range, Range& right, int depth)
    {
        TreeBox middles;
        for (std::size_t k = range.first; k < range.last; ++k) middles.add(reference_[k].middle);
        const Split best = depth < kDeepByArea ? find_split(range, middles) : Split{};
        if (range.count() <= kPerLeaf &&
            !(best.cost < kWorthSplitting * leaf_cost(range.box.area(), range.count())))
            return false;
        const auto begin = reference_.begin();
        auto place = begin + std::ptrdiff_t(range.first + range.count() / 2);
        if (best.axis >= 0)
            place = std::partition(begin + std::ptrdiff_t(range.first),
                begin + std::ptrdiff_t(range.last),
                [&](const Reference& r) { return bin_of(r, middles, best.axis) < best.bin; });
        const std::size_t middle = std::size_t(place - begin);
        right = {middle, range.last, {}};
        range = {range.first, middle, {}};
        for (Range* const half : {&range, &right})
            for (std::size_t k = half->first; k < half->last; ++k) half->box.add(reference_[k].box);
        return true;
    }

    static int bin_of(const Reference& r, const TreeBox& middles, int axis)
    {
        const double low = middles.low[axis], size = double(middles.high[axis]) - low;
        return std::min(kBins - 1, int((double(r.middle[axis]) - low) / size * kBins));
    }

    Split find_split(const Range& range, const TreeBox& middles) const
    {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(middles.high[axis] > middles.low[axis])) continue;
            TreeBox box[kBins];
            std::size_t count[kBins] = {};
            for (std::size_t k = range.first; k < range.last; ++k) {
                const int bin = bin_of(reference_[k], middles, axis);
                box[bin].add(reference_[k].box);
                ++count[bin];
            }
            double right_cost[kBins];
            TreeBox sum;
            std::size_t number = 0;
            for (int bin = kBins - 1; bin > 0; --bin) {
                sum.add(box[bin]);
                number += count[bin];
                right_cost[bin] = leaf_cost(sum.area(), number);
            }
            sum = {};
            number = 0;
            for (int bin = 1; bin < kBins; ++bin) {
                sum.add(box[bin - 1]);
                number += count[bin - 1];
                const double cost = leaf_cost(sum.area(), number) + right_cost[bin];
                if (number > 0 && number < range.count() && cost < best.cost)
                    best = {axis, bin, cost};
            }
        }
        return best;
    }

    std::vector<Reference> reference_;
    TreeTopology topology_;
};

} // namespace

TreeTopology build_topology(const WorldTriangles& triangles)
{
    return TreeBuilder(triangles).build();
}

} // namespace firsthit
