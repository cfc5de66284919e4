// pose_oracle.h - where the corners of a glTF file's triangles are at a time, evaluated slowly.
//
// Written from the specification alone: it reads the JSON itself, keeps everything in double, follows nodes by
// recursion and moves one corner at a time. It shares nothing with the library.
#pragma once

#include <glm/vec3.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace firsthit {

struct OraclePose {
    std::vector<glm::dvec3> corner; // (3 T) world space, in order of triangle ids
};

/// One file.
class PoseOracle {
  public:
    /// Nothing where the file uses what the oracle does not know: compressed buffers, instancing.
    static std::optional<PoseOracle> open(const std::filesystem::path& path);
    ~PoseOracle();
    PoseOracle(PoseOracle&&) noexcept;

    int animations() const;
    /// First and last key of an animation.
    std::pair<double, double> range(int animation) const;
    /// animation  -1: at rest
    OraclePose pose(int animation, double time_s) const;

  private:
    struct Data;
    explicit PoseOracle(std::unique_ptr<Data> data);
    std::unique_ptr<Data> data_;
};

} // namespace firsthit
