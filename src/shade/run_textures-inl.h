// run_textures-inl.h - texture coordinates and footprint gradients of the triangles of many runs.
//
// A large triangle is seen in many blocks, a small one in a single block. Therefore the runs of
// several blocks are prepared before the first of these blocks is shaded: each triangle is computed
// once, and a register holds as many triangles as it has doubles.
#if defined(FIRSTHIT_SHADE_RUN_TEXTURES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADE_RUN_TEXTURES_INL_H_
#undef FIRSTHIT_SHADE_RUN_TEXTURES_INL_H_
#else
#define FIRSTHIT_SHADE_RUN_TEXTURES_INL_H_
#endif

#include "shade/run_setup.h"
#include "visibility/triangle_planes-inl.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Index of a triangle's material.
HWY_INLINE std::uint32_t material_of(const Scene& scene, std::uint32_t item)
{
    return scene.materials.size() == 1 ? 0 : scene.instances[scene.owner[item]].material;
}

/// The results of run_uv and run_gradients, with the same bits, for up to kRuns consecutive runs.
class RunTextures {
  public:
    /// The largest number of runs that are prepared together.
    static constexpr std::size_t kRuns = 192;

    struct Run {
        std::uint32_t material;
        std::uint32_t slot;     // index of the results; kNoTexture: none are needed
        const Texture* texture; // of a material without maps
        MapNeeds needs;         // of a material with maps
    };
    static constexpr std::uint32_t kNoTexture = 0xFFFFFFFF;

    /// Computes the results of the first kRuns of `runs`, or of all if there are fewer, and forgets
    /// earlier results.
    /// arrays  must have uv
    void find(const ShadeArrays& arrays, const Rays& rays, std::span<const HitRun> runs)
    {
        std::array<std::uint8_t, kRecent> recent = {}; // by item: a run that may have the same item
        slots_ = 0;
        const bool in_cache = arrays.scene->vertices <= kCachedVertices;
        for (std::size_t k = 0; k < std::min(kRuns, runs.size()); ++k) {
            if (!in_cache) prefetch(arrays, runs, k);
            const std::uint32_t item = runs[k].item;
            std::uint8_t& same = recent[item % kRecent];
            if (same < k && runs[same].item == item) {
                run_[k] = run_[same];
                continue;
            }
            same = std::uint8_t(k);
            run_[k] = new_run(arrays, item);
        }
        compute_gradients(arrays, rays);
    }

    const Run& operator[](std::size_t run) const { return run_[run]; }

    Interpolated<glm::vec2> uv(std::uint32_t slot) const
    {
        return {vec2(uv_[0], slot), vec2(uv_[1], slot), vec2(uv_[2], slot)};
    }
    RunGradients gradients(std::uint32_t slot) const
    {
        return {vec2(gradient_[0], slot), vec2(gradient_[1], slot), vec2(gradient_[2], slot)};
    }

  private:
    static constexpr std::size_t kRecent = 64;
    static constexpr std::size_t kCachedVertices = 1 << 15; // 24 bytes each
    static_assert(kRuns <= 256);
    using Pair = float[2][kRuns];

    static glm::vec2 vec2(const Pair& pair, std::uint32_t slot)
    {
        return {pair[0][slot], pair[1][slot]};
    }
    static void put(const glm::vec2& value, Pair& pair, std::size_t slot)
    {
        pair[0][slot] = value.x;
        pair[1][slot] = value.y;
    }

    /// Prefetches the indices and corners of the runs ahead.
    static HWY_INLINE void prefetch(
        const ShadeArrays& arrays, std::span<const HitRun> runs, std::size_t run)
    {
        constexpr std::size_t kCorners = 16, kIndices = 32; // runs ahead
        const Scene& scene = *arrays.scene;
        if (run + kIndices < runs.size()) {
            hwy::Prefetch(&scene.index[runs[run + kIndices].item]);
            hwy::Prefetch(&scene.owner[runs[run + kIndices].item]);
        }
        if (run + kCorners < runs.size()) {
            const glm::uvec3& corner = scene.index[runs[run + kCorners].item];
            for (int k = 0; k < 3; ++k) {
                hwy::Prefetch(&arrays.position[corner[k]]);
                hwy::Prefetch(&arrays.uv[corner[k]]);
            }
        }
    }

    Run new_run(const ShadeArrays& arrays, std::uint32_t item)
    {
        const Scene& scene = *arrays.scene;
        Run run{material_of(scene, item), kNoTexture, nullptr, {}};
        const Material& material = scene.materials[run.material];
        if (kModels[material.model.index()].maps.empty())
            run.texture = texture_of(scene, material);
        else
            run.needs = map_needs(arrays, material);
        if (!run.texture && !run.needs.uv[0]) return run;
        run.slot = slots_++;
        const glm::uvec3& corner = scene.index[item];
        item_[run.slot] = item;
        for (int k = 0; k < 3; ++k) {
            const glm::vec3& position = arrays.position[corner[k]];
            for (int axis = 0; axis < 3; ++axis) corner_[3 * k + axis][run.slot] = position[axis];
        }
        const Interpolated<glm::vec2> uv = run_uv(arrays, corner);
        put(uv.at0, uv_[0], run.slot);
        put(uv.to1, uv_[1], run.slot);
        put(uv.to2, uv_[2], run.slot);
        return run;
    }

#if HWY_TARGET == HWY_SCALAR
    void compute_gradients(const ShadeArrays& arrays, const Rays& rays)
    {
        for (std::uint32_t slot = 0; slot < slots_; ++slot) {
            const RunGradients gradients =
                run_gradients(run_plane(arrays, item_[slot], rays), uv(slot), rays);
            put(gradients.u, gradient_[0], slot);
            put(gradients.v, gradient_[1], slot);
            put(gradients.one, gradient_[2], slot);
        }
    }
#else
    /// Vector version of run_plane and run_gradients: one triangle in each lane.
    void compute_gradients(const ShadeArrays& /*arrays*/, const Rays& rays)
    {
        const hn::ScalableTag<double> d;
        const hn::Rebind<float, decltype(d)> f;
        using V = hn::Vec<decltype(d)>;
        const auto same = [&](const glm::vec3& v) {
            return Vector3<V>{
                hn::Set(d, double(v.x)), hn::Set(d, double(v.y)), hn::Set(d, double(v.z))};
        };
        const auto dot = [](const Vector3<V>& a, const Vector3<V>& b) {
            return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
        };
        const Vector3<V> eye = same(rays.eye), right = same(rays.right), down = same(rays.down),
                         forward = same(rays.forward);
        const bool square = rays.step_x == rays.step_y;
        for (std::size_t i = 0; i < slots_; i += hn::Lanes(d)) {
            const auto load = [&](const float* from) {
                return hn::PromoteTo(d, hn::LoadU(f, from + i));
            };
            const auto corner = [&](int k) {
                return Vector3<V>{
                    load(corner_[3 * k]), load(corner_[3 * k + 1]), load(corner_[3 * k + 2])};
            };
            const Vector3<V> p0 = corner(0), p0_eye = rays.parallel ? forward : sub(p0, eye);
            const Vector3<V> e1 = sub(corner(1), p0), e2 = sub(corner(2), p0), n = cross(e1, e2);
            const Vector3<V> w1 = cross(e2, p0_eye), w2 = cross(p0_eye, e1);
            const V n_p0 = dot(n, p0_eye);
            const V step_x = hn::Div(hn::Set(d, double(rays.step_x)), n_p0);
            const V step_y = square ? step_x : hn::Div(hn::Set(d, double(rays.step_y)), n_p0);
            for (int axis = 0; axis < 2; ++axis) {
                const Vector3<V>& along = axis == 0 ? right : down;
                const V step = axis == 0 ? step_x : step_y;
                const V w1_along = hn::Mul(dot(w1, along), step);
                const V w2_along = hn::Mul(dot(w2, along), step);
                const auto store = [&](V v, Pair& pair) {
                    hn::StoreU(hn::DemoteTo(f, v), f, pair[axis] + i);
                };
                for (int c = 0; c < 2; ++c)
                    store(hn::Add(hn::Mul(w1_along, load(uv_[1][c])),
                              hn::Mul(w2_along, load(uv_[2][c]))),
                        gradient_[c]);
                store(rays.parallel ? hn::Zero(d) : hn::Mul(dot(n, along), step), gradient_[2]);
            }
        }
    }
#endif

    std::uint32_t slots_ = 0;
    Run run_[kRuns];
    std::uint32_t item_[kRuns];
    // Indexed by slot. kRuns is a multiple of all register sizes, so whole registers may be
    // written.
    alignas(64) float corner_[9][kRuns];
    alignas(64) Pair uv_[3];       // at0, to1, to2
    alignas(64) Pair gradient_[3]; // of u, v, 1
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
