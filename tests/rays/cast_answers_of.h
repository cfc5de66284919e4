// cast_answers_of.h - all that a RayTree says of rays, for comparison with oracles.
#pragma once

#include "rays/tree/cast_rays.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace firsthit::test {

/// The answers to each ray.
struct CastAnswers {
    std::vector<RayHit> nearest;
    std::vector<std::uint8_t> any;
    std::vector<std::uint32_t> count, all_count;
    std::vector<RayHit> all; // ray by ray
};

/// Triangles that are cast at, without a scene: all are opaque.
class CastMesh {
  public:
    CastMesh(std::vector<glm::vec3> position, std::vector<glm::uvec3> index)
        : position_(std::move(position)),
          index_(std::move(index))
    {
        tree_.build({position_, index_}, tasks_);
    }

    void move(std::vector<glm::vec3> position)
    {
        position_ = std::move(position);
        tree_.refit({position_, index_}, tasks_);
    }

    CastAnswers cast(const std::vector<Ray>& rays) const
    {
        const CastTarget target{tree_, scene_, cutouts_};
        CastAnswers answers;
        answers.nearest.resize(rays.size());
        answers.any.resize(rays.size());
        answers.count.resize(rays.size());
        answers.all_count.resize(rays.size());
        cast_nearest(target, rays, answers.nearest);
        cast_any(target, rays, answers.any);
        cast_count(target, rays, answers.count);
        cast_all(target, rays, answers.all_count, answers.all);
        return answers;
    }

    const std::vector<glm::vec3>& position() const { return position_; }
    const std::vector<glm::uvec3>& index() const { return index_; }
    const RayTree& tree() const { return tree_; }

  private:
    std::vector<glm::vec3> position_;
    std::vector<glm::uvec3> index_;
    Scene scene_;
    Cutouts cutouts_;
    Tasks tasks_{1};
    RayTree tree_;
};

/// Compares the answers with those of an oracle. same(hit, of_oracle) compares t, u and v.
/// returns  the number of rays with a wrong answer
template <class OracleHits, class Same>
std::size_t count_wrong(
    const CastAnswers& answers, std::size_t rays, const OracleHits& oracle, const Same& same)
{
    std::size_t wrong = 0, first = 0;
    for (std::size_t k = 0; k < rays; ++k) {
        const auto hits = oracle(k);
        const RayHit& nearest = answers.nearest[k];
        bool right = answers.any[k] == (hits.empty() ? 0 : 1) && answers.count[k] == hits.size() &&
                     answers.all_count[k] == hits.size();
        right = right &&
                (hits.empty() ? nearest.triangle == kNoItem
                              : nearest.triangle == hits[0].triangle && same(nearest, hits[0], k));
        for (std::size_t h = 0; right && h < hits.size(); ++h) {
            const RayHit& hit = answers.all[first + h];
            right = hit.triangle == hits[h].triangle && same(hit, hits[h], k);
        }
        first += answers.all_count[k];
        wrong += !right;
        if (!right && wrong == 1)
            ADD_FAILURE() << "ray " << k << ": nearest " << nearest.triangle << " at " << nearest.t
                          << ", u " << nearest.u << ", v " << nearest.v << ", " << answers.count[k]
                          << " hits; oracle: " << hits.size() << " hits, nearest "
                          << (hits.empty() ? kNoItem : hits[0].triangle);
    }
    return wrong;
}

} // namespace firsthit::test
