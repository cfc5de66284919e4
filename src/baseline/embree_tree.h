// embree_tree.h - a bounding volume hierarchy over a posed world, brought up to date frame by frame.
#pragma once

#include "rays/embree_handles.h"

#include <firsthit/options/baseline_options.h>
#include <firsthit/scene.h>

#include <embree3/rtcore.h>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <vector>

namespace firsthit {

class EmbreeTree {
  public:
    /// threads  of building
    /// throws   DeviceError
    EmbreeTree(const Scene& scene, BaselineUpdate update, int threads);
    ~EmbreeTree();

    /// The tree over the world's triangles. world.position is read from here on, until the next
    /// update: it has to stay where it is, with room for 4 bytes more behind its end.
    /// returns  the number of triangles that were updated
    /// throws   DeviceError
    std::uint64_t update(const World& world);

    /// The next update takes every part as moved.
    void assume_moved();

    RTCScene scene() const { return handles_.scene; }

    /// The widest packets of rays that Embree has instructions for here: 8 or 16.
    int widest_packet() const { return packet_; }

    /// Triangle 0 of each geometry, as an item; null: there is one geometry.
    const std::uint32_t* first_triangle() const
    {
        return first_triangle_.size() > 1 ? first_triangle_.data() : nullptr;
    }

  private:
    /// Some parts that are updated together.
    struct Group {
        std::size_t first_part, last_part;
        std::uint64_t triangles;
        RTCGeometry geometry = nullptr;
    };
    /// What a part's positions were made from.
    struct PartState {
        glm::dmat4 matrix{0.0};
        bool visible = false;
        double time_s = 0; // of parts that change their shape, else 0
        bool operator==(const PartState&) const = default;
    };

    void build(const World& world);
    void add(const World& world, std::size_t first_part, std::size_t last_part);
    /// Takes the parts' states from the world. Whether one of the group's has changed.
    bool follow(const World& world, const Group& group);

    const Scene& scene_;
    BaselineUpdate update_;
    EmbreeHandles handles_;
    std::vector<Group> groups_;
    std::vector<PartState> parts_;
    std::vector<std::uint32_t> first_triangle_;
    const void* positions_ = nullptr; // that the tree was built over; null: none
    int packet_ = 8;
};

} // namespace firsthit
