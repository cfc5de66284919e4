// obj_faces.cpp - the faces of an OBJ file, and the triangles they become when all vertices are known.
#include "readers/mesh/obj/obj_faces.h"

#include "readers/mesh/triangulate_polygon.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// Corners in faces that cross themselves, each of which takes some microseconds. In a file with more
/// of them faces are no longer cut with care.
constexpr std::size_t kMostCrossing = std::size_t(1) << 18;

constexpr std::uint32_t kNone = ObjCorner::kNone;

bool is_finite(const glm::vec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

} // namespace

void ObjFaces::add(std::span<const ObjCorner> corner, std::size_t line)
{
    for (const ObjCorner& c : corner) {
        last_vertex_ = std::max(last_vertex_, c.vertex);
        has_uv_ |= c.uv != kNone;
        has_normal_ |= c.normal != kNone;
    }
    corner_.insert(corner_.end(), corner.begin(), corner.end());
    if (!smoothing_.empty() || group_ != kNoSmoothingGroup) {
        smoothing_.resize(end_.size(), kNoSmoothingGroup);
        smoothing_.push_back(group_);
    }
    end_.push_back(static_cast<std::uint32_t>(corner_.size()));
    line_.push_back(static_cast<std::uint32_t>(line));
}

void ObjFaces::set_smoothing(std::uint32_t group)
{
    group_ = group;
}

/// Makes the triangles of one face after the other.
class ObjFaces::Maker {
  public:
    Maker(const ObjFaces& faces, RawMesh& mesh)
        : faces_(faces),
          mesh_(mesh),
          uvs_(static_cast<std::uint32_t>(mesh.uv.size())),
          normals_(static_cast<std::uint32_t>(mesh.normal.size()))
    {
        has_uv_ = faces.has_uv_ && uvs_ > 0;
        has_normal_ = faces.has_normal_ && normals_ > 0;
        all_finite_ = std::all_of(mesh.position.begin(), mesh.position.end(), is_finite);
        const std::size_t least = faces.corner_.size() - 2 * faces.count();
        mesh.index.reserve(least);
        if (has_uv_) mesh.uv_index.reserve(least);
        if (has_normal_) mesh.normal_index.reserve(least);
    }

    void make(std::size_t face)
    {
        const std::span<const ObjCorner> corner =
            std::span(faces_.corner_)
                .subspan(faces_.begin(face), faces_.end_[face] - faces_.begin(face));
        if (faces_.has_uv_)
            check(corner, face, &ObjCorner::uv, "texture coordinates that do not exist are 0");
        if (faces_.has_normal_)
            check(corner, face, &ObjCorner::normal, "normals that do not exist are computed");
        if (corner.size() == 3) {
            add(corner, {0, 1, 2}, face);
            return;
        }
        position_.clear();
        triangles_.clear();
        for (const ObjCorner& c : corner) position_.push_back(mesh_.position[c.vertex]);
        if (crossing_ > kMostCrossing) {
            for (std::uint32_t k = 2; k < corner.size(); ++k) triangles_.emplace_back(0u, k - 1, k);
        } else if (!triangulate_polygon(position_, triangles_)) {
            crossing_ += corner.size();
            mesh_.problems.add("faces whose outline crosses itself may be filled wrongly", "line",
                faces_.line_[face]);
        }
        for (const glm::uvec3& t : triangles_) add(corner, t, face);
    }

    /// Where corners have no texture coordinates or normal, theirs is the last one, a zero.
    void add_zeros()
    {
        if (has_uv_)
            mesh_.uv.emplace_back(0);
        else
            mesh_.uv.clear();
        if (has_normal_)
            mesh_.normal.emplace_back(0);
        else
            mesh_.normal.clear();
    }

  private:
    /// Tells of corners that name a value beyond those there are.
    void check(std::span<const ObjCorner> corner, std::size_t face, std::uint32_t ObjCorner::*what,
        std::string_view kind)
    {
        const std::uint32_t values = what == &ObjCorner::uv ? uvs_ : normals_;
        for (const ObjCorner& c : corner)
            if (c.*what >= values && c.*what != kNone)
                mesh_.problems.add(kind, "line", faces_.line_[face]);
    }

    void add(std::span<const ObjCorner> corner, const glm::uvec3& triangle, std::size_t face)
    {
        const ObjCorner &a = corner[triangle.x], &b = corner[triangle.y], &c = corner[triangle.z];
        if (!all_finite_ &&
            !(is_finite(mesh_.position[a.vertex]) && is_finite(mesh_.position[b.vertex]) &&
                is_finite(mesh_.position[c.vertex]))) {
            mesh_.problems.add("triangles with a corner that is not finite are left out", "line",
                faces_.line_[face]);
            return;
        }
        mesh_.index.emplace_back(a.vertex, b.vertex, c.vertex);
        if (!faces_.smoothing_.empty()) mesh_.smoothing.push_back(faces_.smoothing_[face]);
        if (has_uv_)
            mesh_.uv_index.emplace_back(
                std::min(a.uv, uvs_), std::min(b.uv, uvs_), std::min(c.uv, uvs_));
        if (has_normal_)
            mesh_.normal_index.emplace_back(std::min(a.normal, normals_),
                std::min(b.normal, normals_), std::min(c.normal, normals_));
    }

    const ObjFaces& faces_;
    RawMesh& mesh_;
    std::uint32_t uvs_; // that the file has; the number of the zero behind them
    std::uint32_t normals_;
    bool has_uv_;
    bool has_normal_;
    bool all_finite_;
    std::size_t crossing_ = 0;        // corners of faces that cross themselves
    std::vector<glm::vec3> position_; // of a face
    std::vector<glm::uvec3> triangles_;
};

std::vector<std::size_t> ObjFaces::make_triangles(RawMesh& mesh, const std::string& name) const
{
    // A position that does not exist: which, and where?
    const std::size_t vertices = mesh.position.size();
    for (std::size_t face = 0; face < count() && last_vertex_ >= vertices; ++face)
        for (std::size_t c = begin(face); c < end_[face]; ++c)
            if (corner_[c].vertex >= vertices)
                throw SceneError(fmt::format("{}:{}: vertex index {} is out of range ({} vertices)",
                    name, line_[face], std::size_t(corner_[c].vertex) + 1, vertices));

    std::vector<std::size_t> first_triangle;
    first_triangle.reserve(count() + 1);
    Maker maker(*this, mesh);
    for (std::size_t face = 0; face < count(); ++face) {
        first_triangle.push_back(mesh.index.size());
        maker.make(face);
    }
    first_triangle.push_back(mesh.index.size());
    maker.add_zeros();
    return first_triangle;
}

} // namespace firsthit
