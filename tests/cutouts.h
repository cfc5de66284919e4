// cutouts.h - gives the triangles of test worlds materials that let some of their points out.
#pragma once

#include "scenes.h"

#include <algorithm>
#include <random>
#include <vector>

namespace firsthit::test {

/// A texture whose alphas these are, row by row from the top.
inline Texture alpha_texture(int width, int height, const std::vector<int>& alphas)
{
    Picture picture{width, height, {}};
    for (const int alpha : alphas)
        picture.pixel.push_back(std::uint32_t(alpha) << 24 | 0x00FFFFFFu);
    return Texture("alpha", picture);
}

/// Textures of 1x1, 2x2, 5x3 and 16x16 texels with all wrap modes, some of them sampled nearest.
inline std::vector<Texture> alpha_textures(std::mt19937& random)
{
    std::vector<Texture> textures{alpha_texture(1, 1, {127}), alpha_texture(1, 1, {128}),
        alpha_texture(2, 2, {255, 0, 0, 255}), alpha_texture(2, 2, {255, 0, 0, 255})};
    for (const auto& [width, height] : {std::pair{5, 3}, std::pair{16, 16}, std::pair{1, 7}}) {
        std::vector<int> alphas(std::size_t(width * height));
        for (int& alpha : alphas)
            alpha = int(random() % 3 == 0 ? random() % 256 : random() % 2 * 255);
        textures.push_back(alpha_texture(width, height, alphas));
    }
    textures[3].set_sampler({Wrap::repeat, Wrap::mirror, true});
    textures[4].set_sampler({Wrap::clamp, Wrap::mirror, false});
    textures[5].set_sampler({Wrap::mirror, Wrap::clamp, random() % 2 == 0});
    return textures;
}

inline Material random_material(const Scene& scene, std::mt19937& random)
{
    const auto one_of = [&](auto... values) {
        const std::common_type_t<decltype(values)...> all[] = {values...};
        return all[random() % sizeof...(values)];
    };
    Material material;
    material.alpha = one_of(
        AlphaMode::opaque, AlphaMode::mask, AlphaMode::mask, AlphaMode::mask, AlphaMode::blend);
    material.alpha_cutoff = one_of(0.0f, 0.25f, 0.5f, 0.5f, 0.5f, 1.0f, 1.5f);
    material.opacity = one_of(0.0f, 0.3f, 0.5f, 1.0f, 1.0f, 1.0f, 1.0f);
    TextureRef& use = material.opacity_texture;
    use.texture = int(random() % (scene.textures.size() + 1)) - 1;
    use.uv_set = int(random() % 2);
    const auto number = [&](float size) {
        return std::uniform_real_distribution<float>(-size, size)(random);
    };
    if (random() % 2 == 0) return material;
    const float scale = one_of(0.3f, 1.0f, 4.0f, 300.0f);
    use.transform = glm::mat3x2(
        number(scale), number(scale), number(scale), number(scale), number(scale), number(scale));
    return material;
}

/// Divides the triangles of a finished world into parts of random materials, and gives its vertices
/// texture coordinates, some far out, and colours.
///
/// colored  whether vertices have colours; without them materials may be opaque everywhere
inline void make_cutouts(TestWorld& world, std::mt19937& random, bool colored)
{
    Scene& scene = *world.scene;
    scene.textures = alpha_textures(random);
    scene.materials.clear();
    scene.instances.clear();
    const auto number = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    scene.uv.clear(), scene.uv1.clear(), scene.color.clear();
    for (std::size_t k = 0; k < world.world.position.size(); ++k) {
        const float far = random() % 50 == 0 ? 1e6f : 3.0f;
        scene.uv.emplace_back(number(-far, far), number(-2, 2));
        scene.uv1.emplace_back(float(int(random() % 9) - 4) * 0.5f, float(random() % 5) * 0.25f);
        const float alphas[] = {0, 1, 1, 1, number(0, 1)};
        if (colored) scene.color.emplace_back(1, 1, 1, alphas[random() % 5]);
    }
    for (std::uint32_t first = 0; first < scene.index.size();) {
        Instance part;
        part.first_triangle = first;
        part.triangle_count =
            std::min(std::uint32_t(1 + random() % 5), std::uint32_t(scene.index.size()) - first);
        part.material = std::uint32_t(scene.materials.size());
        scene.materials.push_back(random_material(scene, random));
        for (std::uint32_t k = 0; k < part.triangle_count; ++k)
            scene.owner[first + k] = std::uint32_t(scene.instances.size());
        first += part.triangle_count;
        scene.instances.push_back(part);
    }
}

} // namespace firsthit::test
