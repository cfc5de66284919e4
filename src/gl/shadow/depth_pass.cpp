// depth_pass.cpp - draws shadow maps with OpenGL.
#include "gl/shadow/depth_pass.h"

#include "exact/hit.h"
#include "gl/bindings.h"
#include "gl/device/context.h"
#include "gl/device/program.h"
#include "shadow/map/map_pencil.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace firsthit::gl {
namespace {

/// The uniform `range` of shadow_depth.vert. For a parallel light it is the greatest depth. For
/// other lights it is a depth that is smaller than that of any triangle that matters; reversed
/// float depths lose no precision however small it is.
float depth_range(const World& world, const Pencil& pencil)
{
    if (pencil.parallel) return float(0.5 * pencil.far);
    double farthest = 0;
    for (const glm::vec3& p : world.position) {
        if (!usable(p)) continue;
        const glm::dvec3 d = glm::abs(glm::dvec3(p) - pencil.eye);
        farthest = std::max({farthest, d.x, d.y, d.z});
    }
    return float(std::max(farthest * 0x1p-24, 1e-30));
}

} // namespace

DepthPass::DepthPass()
    : draw_(link_program({"shadow_depth.vert", "shadow_depth.frag"})),
      store_(link_program({"store_map.comp"}))
{
    triangles_.create();
}

void DepthPass::draw(const World& world, const SceneBuffers& scene, const MapTexels& texels,
    const MapNumber& number, ShadowMaps& maps)
{
    ShadowMap& map = map_of(maps, number);
    const std::uint32_t first = texels.first()[number.light * kFaces + std::size_t(number.face)];
    const Pencil pencil = set_map_transform(world, number.face, map);
    const float range = depth_range(world, pencil);
    const int width = map.width(), height = map.height();
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (std::max(width, height) > most)
        throw DeviceError(fmt::format("OpenGL: a shadow map of {}x{} texels is too large, {} on a "
                                      "side are possible ({})",
            width, height, most, driver_name()));
    if (width > depth_.width() || height > depth_.height()) {
        depth_.resize(GL_DEPTH_COMPONENT32F, std::max(width, depth_.width()),
            std::max(height, depth_.height()));
        target_.attach(GL_DEPTH_ATTACHMENT, depth_.name());
        target_.check_complete("drawing a shadow map");
    }
    triangles_.set_indices(scene.index());
    world_.look_at(scene.world(), GL_RGBA32F, 16);
    world_.bind(kWorldUnit);

    draw_.use();
    const glm::mat3 matrix(map.matrix);
    const glm::vec3 origin(map.origin);
    const glm::vec3 offset(map.offset + map.matrix * (glm::dvec3(origin) - map.origin));
    glUniformMatrix3fv(kDrawMatrix, 1, GL_FALSE, glm::value_ptr(matrix));
    glUniform3fv(kDrawOrigin, 1, glm::value_ptr(origin));
    glUniform3fv(kDrawOffset, 1, glm::value_ptr(offset));
    glUniform2f(kDrawSize, float(width), float(height));
    glUniform1f(kDrawRange, range);
    glUniform1i(kDrawParallel, pencil.parallel);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glBindVertexArray(triangles_.name());
    glViewport(0, 0, width, height);
    // Depth is reversed, and triangles near the light are not clipped.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    const float nothing = 0;
    glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &nothing);
    glDrawElements(GL_TRIANGLES, GLsizei(3 * scene.triangles()), GL_UNSIGNED_INT, nullptr);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_DEPTH_CLAMP);

    store_.use();
    glUniform2i(kStoreSize, width, height);
    glUniform1ui(kStoreFirst, first);
    glUniform1f(kStoreRange, range);
    glUniform1i(kStoreParallel, pencil.parallel);
    depth_.bind(kDepthUnit);
    texels.bind_storage(kResultBlock);
    glDispatchCompute(GLuint(quads(width)), GLuint(quads(height)), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    check("drawing a shadow map");
}

void DepthPass::draw_changed(
    const World& world, const SceneBuffers& scene, const MapTexels& texels, ShadowMaps& maps)
{
    for (const MapNumber& number : maps.changed) draw(world, scene, texels, number, maps);
}

} // namespace firsthit::gl
