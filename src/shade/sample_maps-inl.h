// sample_maps-inl.h - the textures of a material with maps, for the samples of a block.
#if defined(FIRSTHIT_SHADE_SAMPLE_MAPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_SAMPLE_MAPS_INL_H_
#undef FIRSTHIT_SHADE_SAMPLE_MAPS_INL_H_
#else
#define FIRSTHIT_SHADE_SAMPLE_MAPS_INL_H_
#endif

#include "shade/sample_texture-inl.h"

#include <array>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// The maps of a model at the samples of a block. Only samples that were asked for are defined.
template <std::size_t maps>
struct BlockMaps {
    /// Red, green, blue, and alpha where has_alpha(); null: 1.
    const float (*map[maps])[kBlockSamples] = {};
    alignas(64) float light[maps][4][kBlockSamples];
};

/// Whether two maps are looked up at the same texels, with the same weights.
HWY_INLINE bool same_places(
    const Texture& a, const TextureRef& map_a, const Texture& b, const TextureRef& map_b)
{
    return map_a.uv_set == map_b.uv_set && map_a.transform == map_b.transform &&
           a.width() == b.width() && a.height() == b.height() && a.levels() == b.levels() &&
           a.sampler().wrap_u == b.sampler().wrap_u && a.sampler().wrap_v == b.sampler().wrap_v &&
           a.sampler().nearest == b.sampler().nearest;
}

/// Finds the texels of a map.
HWY_NOINLINE void find_map_texels(const Texture& texture, const TextureRef& map,
    const BlockAttributes& attributes, std::uint64_t samples, BlockTexels& texels)
{
    const bool second = map.uv_set != 0;
    const auto& step = attributes.uv_step[second ? 1 : 0];
    const glm::mat3x2& m = map.transform;
    const real2 size(static_cast<float>(texture.width()), static_cast<float>(texture.height()));
    alignas(64) float length2[kBlockSamples];
    for (int first = 0; first < kBlockSamples; first += kLanes) {
        if (lane_bits(samples, first) == 0) continue;
        store(moved_footprint2(real2(load(step[0] + first), load(step[1] + first)),
                  real2(load(step[2] + first), load(step[3] + first)), from_glm(m[0]),
                  from_glm(m[1]), size),
            length2 + first);
    }
    BlockTexCoords coords;
    texels.blended = find_map_coords(
        {texture, map, second ? attributes.uv1 : attributes.uv, length2}, samples, coords);
    find_texels<false>(texture, coords, samples, texels.finer);
    find_texels<true>(texture, coords, texels.blended, texels.coarser);
}

/// Samples the maps of a model. A texture that two of them look at in the same way is sampled once.
template <class Model, std::size_t maps>
HWY_INLINE void sample_maps(const ShadeArrays& arrays, const Model& model,
    const BlockAttributes& attributes, std::uint64_t samples, BlockMaps<maps>& sampled)
{
    std::array<const Texture*, maps> texture;
    BlockTexels texels;
    std::size_t found = maps; // whose texels these are
    for (std::size_t k = 0; k < maps; ++k) {
        const TextureRef& map = map_of(model, kMapsOf<Model>[k]);
        texture[k] = texture_of(arrays, map);
        if (!texture[k]) continue;
        const auto is_like = [&](std::size_t other) {
            return same_places(
                *texture[k], map, *texture[other], map_of(model, kMapsOf<Model>[other]));
        };
        for (std::size_t other = 0; other < k; ++other)
            if (texture[other] == texture[k] && is_like(other)) sampled.map[k] = sampled.map[other];
        if (sampled.map[k]) continue;
        if (found == maps || !is_like(found)) {
            find_map_texels(*texture[k], map, attributes, samples, texels);
            found = k;
        }
        // Another map may look at the same texture for its alpha.
        bool alpha = false;
        for (std::size_t other = k; other < maps; ++other)
            alpha |= has_alpha(kMapsOf<Model>[other]) &&
                     map_of(model, kMapsOf<Model>[other]).texture == map.texture;
        if (alpha)
            weigh_texels<true>(*texture[k], texels, samples, sampled.light[k]);
        else
            weigh_texels<false>(*texture[k], texels, samples, sampled.light[k]);
        sampled.map[k] = sampled.light[k];
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
