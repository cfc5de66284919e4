// scene_buffers.cpp - a world's triangles on OpenGL: what never moves goes there once.
#include "gl/scene/scene_buffers.h"

#include "gl/device/program.h"
#include "scene/animate/pose_kernel.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstring>

namespace firsthit::gl {
namespace {

/// Of pose.comp.
constexpr std::uint32_t kGroup = 64;
constexpr std::uint32_t kGroupsInRow = 32768;

/// Blocks may start at these offsets: no driver asks for more.
constexpr std::size_t kBlockAlignment = 256;

bool is_moving(const Part& part)
{
    return !part.morph.empty() || bool(part.deform);
}

MatrixData matrix_data(const glm::dmat4& world_from_node, bool visible)
{
    MatrixData data;
    if (!visible) { // collapsed to a point, as on the CPU
        for (int r = 0; r < 3; ++r) data.world[r].w = float(world_from_node[3][r]);
        return data;
    }
    const VertexMatrix matrix = vertex_matrix(world_from_node);
    for (int r = 0; r < 3; ++r) {
        std::copy_n(matrix.point + 4 * r, 4, &data.world[r].x);
        std::copy_n(matrix.normal + 3 * r, 3, &data.normal[r].x);
    }
    return data;
}

} // namespace

SceneBuffers::SceneBuffers(const Context& context, Detail detail)
    : limits_(context.info()),
      detail_(detail),
      program_(link_program(
          {"pose.comp"}, Defines{{"SURFACES", detail == Detail::surfaces ? "1" : "0"}})),
      vertices_location_(program_.location("vertices")),
      eye_point_location_(program_.location("eye_point")),
      eye_row_location_(program_.location("eye_row"))
{
}

void SceneBuffers::pose(const World& world, const Pencil& pencil)
{
    if (!update(world, pencil) && !eye_is_lent_) return;
    run_pose();
    eye_is_lent_ = false;
}

void SceneBuffers::lend_eye_space(
    const World& world, const Pencil& pencil, std::span<const glm::vec4> corner)
{
    // Surfaces need the rest of what posing makes; items need nothing but what is lent.
    if (detail_ == Detail::surfaces) {
        if (update(world, pencil)) {
            run_pose();
            eye_is_lent_ = false;
        }
    } else {
        check_sizes(*world.scene);
        upload_scene(*world.scene);
    }
    if (kept_lent_.follow(corner.first(vertices_)) || !eye_is_lent_) {
        eye_is_lent_ = false; // until it is there
        eye_.resize(vertices_ * sizeof(glm::vec4));
        eye_.upload(0, corner.data(), vertices_ * sizeof(glm::vec4));
        uploaded_bytes_ += vertices_ * sizeof(glm::vec4);
        eye_is_lent_ = true;
    }
    check("uploading vertices");
}

/// Everything that posing reads.
/// returns  whether something is new
bool SceneBuffers::update(const World& world, const Pencil& pencil)
{
    check_sizes(*world.scene);
    const bool same_eye =
        pencil.eye == eye_point_ && pencil.eye_from_world == eye_from_world_ && poses_ > 0;
    eye_point_ = pencil.eye;
    eye_from_world_ = pencil.eye_from_world;
    bool is_new = upload_scene(*world.scene);
    is_new |= upload_parts(*world.scene);
    is_new |= upload_matrices(world);
    is_new |= upload_moving(world);
    check("uploading the scene");
    return is_new || !same_eye;
}

void SceneBuffers::check_sizes(const Scene& scene) const
{
    const auto check_size = [&](const char* what, std::size_t count, std::size_t each) {
        const std::uint64_t bytes = std::uint64_t(count) * each;
        if (bytes > std::uint64_t(limits_.max_storage_bytes))
            throw DeviceError(
                fmt::format("OpenGL: {}: {} {} take {} bytes, one buffer may have {} ({}, {})",
                    scene.name.empty() ? "scene" : scene.name, count, what, bytes,
                    limits_.max_storage_bytes, limits_.renderer, limits_.version));
    };
    check_size("vertices", scene.vertices, sizeof(glm::vec4));
    check_size("triangles", scene.index.size(), sizeof(glm::uvec3));
}

/// Uploads an array where it is not the one that was uploaded last.
template <class T>
bool SceneBuffers::upload_new(std::span<const T> values, KeptCopy<T>& kept, Buffer& buffer)
{
    if (!kept.follow(values)) return false;
    kept.forget(); // until it is there
    buffer.assign(values);
    uploaded_bytes_ += values.size_bytes();
    kept.keep();
    return true;
}

/// What does not depend on parts.
bool SceneBuffers::upload_scene(const Scene& scene)
{
    const auto span = [](const auto& values) { return std::span(values.data(), values.size()); };
    bool is_new = vertices_ != scene.vertices;
    vertices_ = std::uint32_t(scene.vertices);
    triangles_ = std::uint32_t(scene.index.size());
    has_uv_ = !scene.uv.empty();
    upload_new(span(scene.index), kept_index_, index_); // not read by posing
    is_new |= upload_new(span(scene.position), kept_rest_position_, rest_position_);
    if (detail_ == Detail::items) return is_new;
    is_new |= upload_new(span(scene.normal), kept_rest_normal_, rest_normal_);
    upload_new(span(scene.uv), kept_uv_, uv_);
    return is_new;
}

/// The parts' table, and what each vertex and triangle has from its part.
bool SceneBuffers::upload_parts(const Scene& scene)
{
    parts_.clear();
    std::uint32_t moving = 0;
    for (const Part& part : scene.parts) {
        PartData data;
        data.moving = is_moving(part);
        data.matrix = part.node;
        data.first = moving;
        data.first_vertex = part.first_vertex;
        data.vertex_count = part.vertex_count;
        data.material = part.material;
        if (data.moving) moving += part.vertex_count;
        parts_.push_back(data);
    }
    const bool new_parts = upload_new(std::span<const PartData>(parts_), kept_part_, part_);
    if (new_parts) {
        scratch_.assign(scene.vertices, 0);
        for (std::size_t p = 0; p < scene.parts.size(); ++p)
            std::fill_n(scratch_.begin() + scene.parts[p].first_vertex, scene.parts[p].vertex_count,
                std::uint32_t(p));
        part_of_.assign(std::span<const std::uint32_t>(scratch_));
        uploaded_bytes_ += scratch_.size() * sizeof(std::uint32_t);
    }
    if (detail_ == Detail::surfaces &&
        (kept_owner_.follow(std::span(scene.owner.data(), scene.owner.size())) || new_parts)) {
        scratch_.clear();
        for (const std::uint32_t owner : scene.owner)
            scratch_.push_back(scene.parts[owner].material);
        material_.assign(std::span<const std::uint32_t>(scratch_));
        uploaded_bytes_ += scratch_.size() * sizeof(std::uint32_t);
    }
    return new_parts;
}

/// The matrices of nodes that parts hang on, where they differ from the last frame's.
bool SceneBuffers::upload_matrices(const World& world)
{
    const bool resized = matrices_.size() != world.node_matrix.size();
    if (resized) {
        matrices_.assign(world.node_matrix.size(), MatrixData{});
        matrix_.assign(std::span<const MatrixData>(matrices_));
        uploaded_bytes_ += matrices_.size() * sizeof(MatrixData);
    }
    bool is_new = resized;
    std::size_t last = matrices_.size(); // parts of one node mostly follow each other
    for (const PartData& part : parts_) {
        const std::size_t node = part.matrix;
        if (node == last || part.moving || part.vertex_count == 0) continue;
        last = node;
        const MatrixData data = matrix_data(world.node_matrix[node], world.node_visible[node] != 0);
        if (matrices_[node] == data) continue;
        matrix_.upload(node * sizeof(MatrixData), &data, sizeof(MatrixData));
        matrices_[node] = data;
        uploaded_bytes_ += sizeof(MatrixData);
        is_new = true;
    }
    return is_new;
}

/// World-space vertices of the parts that morph or deform, into the segment that is not in use.
bool SceneBuffers::upload_moving(const World& world)
{
    moving_position_.clear();
    moving_normal_.clear();
    std::size_t count = 0, moving_parts = 0;
    const PartData* only = nullptr;
    for (const PartData& part : parts_) {
        if (!part.moving) continue;
        count += part.vertex_count;
        ++moving_parts;
        only = &part;
    }
    if (count == 0) {
        ring_.segment_bytes = 0;
        if (ring_.buffer.capacity() == 0) ring_.buffer.resize(4);
        return false;
    }
    // One part is read where it is; several are gathered.
    std::span<const glm::vec3> position, normal;
    const bool surfaces = detail_ == Detail::surfaces;
    if (moving_parts == 1) {
        position = std::span(world.position).subspan(only->first_vertex, count);
        normal = std::span(world.normal).subspan(only->first_vertex, count);
    } else {
        for (const PartData& part : parts_) {
            if (!part.moving) continue;
            const auto first = std::ptrdiff_t(part.first_vertex);
            const auto last = first + std::ptrdiff_t(part.vertex_count);
            moving_position_.insert(moving_position_.end(), world.position.begin() + first,
                world.position.begin() + last);
            if (surfaces)
                moving_normal_.insert(moving_normal_.end(), world.normal.begin() + first,
                    world.normal.begin() + last);
        }
        position = moving_position_;
        normal = moving_normal_;
    }
    bool is_new = kept_moving_.follow(position);
    if (surfaces) is_new |= kept_moving_normal_.follow(normal);
    if (!is_new && ring_.segment_bytes > 0) return false;

    const std::size_t bytes = position.size_bytes();
    const auto rounded = [](std::size_t size) {
        return (size + kBlockAlignment - 1) / kBlockAlignment * kBlockAlignment;
    };
    ring_.normal_offset = rounded(bytes);
    const std::size_t segment_bytes = ring_.normal_offset * (surfaces ? 2 : 1);
    if (segment_bytes != ring_.segment_bytes) {
        for (Fence& fence : ring_.was_read) fence.wait("posing");
        ring_.buffer.resize(ring_.was_read.size() * segment_bytes,
            GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT);
        ring_.segment_bytes = segment_bytes;
    }
    ring_.segment = (ring_.segment + 1) % ring_.was_read.size();
    ring_.was_read[ring_.segment].wait("posing");
    std::byte* const to = ring_.buffer.mapped() + ring_.segment * segment_bytes;
    std::memcpy(to, position.data(), bytes);
    if (surfaces) std::memcpy(to + ring_.normal_offset, normal.data(), bytes);
    uploaded_bytes_ += bytes * (surfaces ? 2 : 1);
    return true;
}

void SceneBuffers::run_pose()
{
    eye_.resize(vertices_ * sizeof(glm::vec4));
    const bool surfaces = detail_ == Detail::surfaces;
    if (surfaces) {
        world_.resize(vertices_ * sizeof(glm::vec4));
        normal_.resize(vertices_ * sizeof(glm::vec4));
    }
    if (vertices_ == 0) return;

    program_.use();
    glUniform1ui(vertices_location_, vertices_);
    glUniform3d(eye_point_location_, eye_point_.x, eye_point_.y, eye_point_.z);
    const glm::dmat3 rows = glm::transpose(eye_from_world_);
    glUniform3dv(eye_row_location_, 3, &rows[0].x);
    matrix_.bind_storage(0);
    part_.bind_storage(1);
    part_of_.bind_storage(2);
    rest_position_.bind_storage(3);
    const bool moving = ring_.segment_bytes > 0;
    const auto bind_moving = [&](GLuint binding, std::size_t offset, std::size_t bytes) {
        if (!moving) return ring_.buffer.bind_storage(binding);
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, ring_.buffer.name(),
            GLintptr(ring_.segment * ring_.segment_bytes + offset), GLsizeiptr(bytes));
    };
    bind_moving(4, 0, ring_.normal_offset);
    eye_.bind_storage(5);
    if (surfaces) {
        rest_normal_.bind_storage(6);
        bind_moving(7, ring_.normal_offset, ring_.normal_offset);
        world_.bind_storage(8);
        normal_.bind_storage(9);
    }
    const std::uint32_t groups = (vertices_ + kGroup - 1) / kGroup;
    const std::uint32_t columns = std::min(groups, kGroupsInRow);
    glDispatchCompute(columns, (groups + columns - 1) / columns, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
    if (moving) ring_.was_read[ring_.segment].insert();
    glUseProgram(0);
    ++poses_;
    check("posing");
}

} // namespace firsthit::gl
