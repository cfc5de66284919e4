// scene_buffers.cpp - uploads a scene to OpenGL and poses its vertices there.
#include "gl/scene/scene_buffers.h"

#include "gl/bindings.h"
#include "gl/device/program.h"
#include "scene/animate/pose_kernel.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstring>

namespace firsthit::gl {
namespace {

/// Work group size of pose.comp, and the largest row of work groups that is dispatched.
constexpr std::uint32_t kGroup = 64;
constexpr std::uint32_t kGroupsInRow = 32768;

/// Alignment of storage blocks inside a buffer, bytes. No driver needs more.
constexpr std::size_t kBlockAlignment = 256;

bool is_moving(const Instance& instance)
{
    return instance.changes_shape();
}

MatrixData matrix_data(const glm::dmat4& world_from_node, bool visible)
{
    MatrixData data;
    if (!visible) { // collapses to a point, as on the CPU
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
    // Surfaces need the other results of posing, too. Items need only the eye space.
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
        eye_is_lent_ = false; // until the upload is done
        eye_.resize(vertices_ * sizeof(glm::vec4));
        eye_.upload(0, corner.data(), vertices_ * sizeof(glm::vec4));
        uploaded_bytes_ += vertices_ * sizeof(glm::vec4);
        eye_is_lent_ = true;
    }
    check("uploading vertices");
}

/// Uploads everything that posing reads.
/// returns  whether anything of it has changed
bool SceneBuffers::update(const World& world, const Pencil& pencil)
{
    check_sizes(*world.scene);
    const bool same_eye =
        pencil.eye == eye_point_ && pencil.eye_from_world == eye_from_world_ && poses_ > 0;
    eye_point_ = pencil.eye;
    eye_from_world_ = pencil.eye_from_world;
    bool is_new = upload_scene(*world.scene);
    is_new |= upload_instances(*world.scene);
    is_new |= upload_matrices(world);
    is_new |= upload_moving(world);
    upload_tangents(world); // not read by posing
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

/// Uploads an array if it differs from its last upload.
template <class T>
bool SceneBuffers::upload_new(std::span<const T> values, KeptCopy<T>& kept, Buffer& buffer)
{
    if (!kept.follow(values)) return false;
    kept.forget(); // until the upload is done
    buffer.assign(values);
    uploaded_bytes_ += values.size_bytes();
    kept.keep();
    return true;
}

/// Uploads the arrays that do not depend on scene instances.
bool SceneBuffers::upload_scene(const Scene& scene)
{
    const auto span = [](const auto& values) { return std::span(values.data(), values.size()); };
    bool is_new = vertices_ != scene.vertices;
    vertices_ = std::uint32_t(scene.vertices);
    triangles_ = std::uint32_t(scene.index.size());
    has_uv_ = !scene.uv.empty();
    has_uv1_ = !scene.uv1.empty();
    has_color_ = !scene.color.empty();
    upload_new(span(scene.index), kept_index_, index_); // posing does not read it
    is_new |= upload_new(span(scene.position), kept_rest_position_, rest_position_);
    if (detail_ == Detail::items) return is_new;
    is_new |= upload_new(span(scene.normal), kept_rest_normal_, rest_normal_);
    upload_new(span(scene.uv), kept_uv_, uv_);
    upload_new(span(scene.uv1), kept_uv1_, uv1_);
    upload_new(span(scene.color), kept_color_, color_);
    return is_new;
}

/// Uploads the table of scene instances, the instance of each vertex, and the material of each triangle.
bool SceneBuffers::upload_instances(const Scene& scene)
{
    instances_.clear();
    std::uint32_t moving = 0;
    for (const Instance& instance : scene.instances) {
        InstanceData data;
        data.moving = is_moving(instance);
        data.matrix = instance.node;
        data.first = moving;
        data.first_vertex = instance.first_vertex;
        data.vertex_count = instance.vertex_count;
        data.material = instance.material;
        if (data.moving) moving += instance.vertex_count;
        instances_.push_back(data);
    }
    const bool new_instances =
        upload_new(std::span<const InstanceData>(instances_), kept_instance_, instance_);
    if (new_instances) {
        scratch_.assign(scene.vertices, 0);
        for (std::size_t p = 0; p < scene.instances.size(); ++p)
            std::fill_n(scratch_.begin() + scene.instances[p].first_vertex,
                scene.instances[p].vertex_count, std::uint32_t(p));
        instance_of_.assign(std::span<const std::uint32_t>(scratch_));
        uploaded_bytes_ += scratch_.size() * sizeof(std::uint32_t);
    }
    if (detail_ == Detail::surfaces &&
        (kept_owner_.follow(std::span(scene.owner.data(), scene.owner.size())) || new_instances)) {
        scratch_.clear();
        for (const std::uint32_t owner : scene.owner)
            scratch_.push_back(scene.instances[owner].material);
        material_.assign(std::span<const std::uint32_t>(scratch_));
        uploaded_bytes_ += scratch_.size() * sizeof(std::uint32_t);
    }
    return new_instances;
}

/// Uploads the matrices of the scene instances' nodes that have changed since the last frame.
bool SceneBuffers::upload_matrices(const World& world)
{
    const bool resized = matrices_.size() != world.node_matrix.size();
    if (resized) {
        matrices_.assign(world.node_matrix.size(), MatrixData{});
        matrix_.assign(std::span<const MatrixData>(matrices_));
        uploaded_bytes_ += matrices_.size() * sizeof(MatrixData);
    }
    bool is_new = resized;
    std::size_t last = matrices_.size(); // consecutive instances often have the same node
    for (const InstanceData& instance : instances_) {
        const std::size_t node = instance.matrix;
        if (node == last || instance.moving || instance.vertex_count == 0) continue;
        last = node;
        const MatrixData data = matrix_data(world.node_matrix[node], world.node_visible[node] != 0);
        if (std::memcmp(&matrices_[node], &data, sizeof data) == 0) continue;
        matrix_.upload(node * sizeof(MatrixData), &data, sizeof(MatrixData));
        matrices_[node] = data;
        uploaded_bytes_ += sizeof(MatrixData);
        is_new = true;
    }
    return is_new;
}

/// Uploads the world-space vertices of the instances that morph or deform, to the segment that is not
/// in use.
bool SceneBuffers::upload_moving(const World& world)
{
    moving_position_.clear();
    moving_normal_.clear();
    std::size_t count = 0, moving_instances = 0;
    const InstanceData* only = nullptr;
    for (const InstanceData& instance : instances_) {
        if (!instance.moving) continue;
        count += instance.vertex_count;
        ++moving_instances;
        only = &instance;
    }
    if (count == 0) {
        ring_.segment_bytes = 0;
        if (ring_.buffer.capacity() == 0) ring_.buffer.resize(4);
        return false;
    }
    // A single instance is copied from the world; several are gathered first.
    std::span<const glm::vec3> position, normal;
    const bool surfaces = detail_ == Detail::surfaces;
    if (moving_instances == 1) {
        position = std::span(world.position).subspan(only->first_vertex, count);
        normal = std::span(world.normal).subspan(only->first_vertex, count);
    } else {
        for (const InstanceData& instance : instances_) {
            if (!instance.moving) continue;
            const auto first = std::ptrdiff_t(instance.first_vertex);
            const auto last = first + std::ptrdiff_t(instance.vertex_count);
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

/// As the CPU has posed them.
void SceneBuffers::upload_tangents(const World& world)
{
    has_tangent_ = !world.tangent.empty();
    if (detail_ == Detail::surfaces)
        upload_new(std::span(world.tangent.data(), world.tangent.size()), kept_tangent_, tangent_);
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
    matrix_.bind_storage(kPoseMatricesBlock);
    instance_.bind_storage(kPoseInstancesBlock);
    instance_of_.bind_storage(kPoseInstanceOfVertexBlock);
    rest_position_.bind_storage(kPoseRestPositionsBlock);
    const bool moving = ring_.segment_bytes > 0;
    const auto bind_moving = [&](GLuint binding, std::size_t offset, std::size_t bytes) {
        if (!moving) return ring_.buffer.bind_storage(binding);
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, ring_.buffer.name(),
            GLintptr(ring_.segment * ring_.segment_bytes + offset), GLsizeiptr(bytes));
    };
    bind_moving(kPoseMovingPositionsBlock, 0, ring_.normal_offset);
    eye_.bind_storage(kPoseEyeBlock);
    if (surfaces) {
        rest_normal_.bind_storage(kPoseRestNormalsBlock);
        bind_moving(kPoseMovingNormalsBlock, ring_.normal_offset, ring_.normal_offset);
        world_.bind_storage(kPoseWorldBlock);
        normal_.bind_storage(kPoseNormalsBlock);
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
