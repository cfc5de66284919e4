// embree_tree.h - Embree's bounding volume hierarchy of a posed world, which is updated frame by
// frame.
#pragma once

#include "rays/embree_handles.h"

#include <firsthit/options/baseline_options.h>
#include <firsthit/scene.h>

#include <embree3/rtcore.h>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace firsthit {

/// Embree's device and scene for the worlds of one scene.
class EmbreeTree {
  public:
    /// scene    outlives this
    /// threads  threads that build and update the tree
    /// throws   DeviceError
    EmbreeTree(const Scene& scene, BaselineUpdate update, int threads);
    ~EmbreeTree();

    /// Updates the tree for the world's triangles. The tree refers to world.position until the next
    /// update: the vertices have to stay where they are, and 4 more bytes behind their end have to
    /// be readable.
    ///
    /// returns  the number of triangles that were updated
    /// throws   DeviceError
    std::uint64_t update(const World& world);

    /// Makes the next update treat every instance as moved.
    void assume_moved();

    /// For rays; valid after an update.
    RTCScene scene() const { return handles_.scene; }

    /// The widest packets of rays that Embree has instructions for here: 8 or 16.
    int widest_packet() const { return packet_; }

    /// (geometries) the item of triangle 0 of each geometry; null if there is only one geometry.
    const std::uint32_t* first_triangle() const
    {
        return first_triangle_.size() > 1 ? first_triangle_.data() : nullptr;
    }

  private:
    /// Consecutive instances that form one geometry, and are updated together.
    struct Group {
        std::size_t first_instance, last_instance; // last_instance is not in the group
        std::uint64_t triangles;
        RTCGeometry geometry = nullptr;
    };
    /// What the positions of an instance were computed from.
    struct InstanceState {
        glm::dmat4 matrix{0.0};
        bool visible = false;
        double time_s = 0; // 0 for instances that do not change their shape
        bool operator==(const InstanceState&) const = default;
    };

    /// Builds the tree anew.
    void build(const World& world);
    /// Adds a geometry of the instances [first_instance, last_instance).
    void add(const World& world, std::size_t first_instance, std::size_t last_instance);
    /// Copies the states of the group's instances from the world, and returns whether one has changed.
    bool follow(const World& world, const Group& group);

    const Scene& scene_;
    BaselineUpdate update_;
    EmbreeHandles handles_;
    std::vector<Group> groups_;
    std::vector<InstanceState> instances_;
    std::vector<std::uint32_t> first_triangle_;
    const void* positions_ =
        nullptr; // the positions that the tree refers to; null before it is built
    int packet_ = 8;
};

} // namespace firsthit
