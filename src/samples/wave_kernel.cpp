// wave_kernel.cpp - heights and normals of a row of the wave's cloth, a register at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "samples/wave_kernel.cpp"
#include "base/simd.h"

#include "samples/wave_kernel.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, kWavePadding>;

HWY_INLINE void fill_register(const WaveColumns& columns, const WaveRow& row, std::size_t column,
    float* position, float* normal)
{
    const Floats d;
    const auto set = [&](float v) { return hn::Set(d, v); };
    auto y = hn::Zero(d), nx = y, nz = y;
    for (std::size_t k = 0; k < kWaveCount; ++k) {
        const auto sine = hn::LoadU(d, columns.sine[k] + column);
        const auto cosine = hn::LoadU(d, columns.cosine[k] + column);
        const auto p = set(row.p[k]), q = set(row.q[k]);
        y = hn::Add(y, hn::Add(hn::Mul(sine, p), hn::Mul(cosine, q)));
        const auto slope = hn::Sub(hn::Mul(cosine, p), hn::Mul(sine, q));
        nx = hn::Sub(nx, hn::Mul(set(row.a[k]), slope));
        nz = hn::Sub(nz, hn::Mul(set(row.b[k]), slope));
    }
    const auto one = set(1.0f);
    const auto length = hn::Sqrt(hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(nz, nz)), one));
    const auto ny = hn::Div(one, length);
    hn::StoreInterleaved3(hn::LoadU(d, columns.x + column), y, set(row.z), d, position);
    hn::StoreInterleaved3(hn::Mul(nx, ny), ny, hn::Mul(nz, ny), d, normal);
}

void fill(const WaveColumns& columns, const WaveRow& row, std::size_t column, std::size_t count,
    float* position, float* normal)
{
    const std::size_t lanes = hn::Lanes(Floats());
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes)
        fill_register(columns, row, column + k, position + 3 * k, normal + 3 * k);
    if (k == count) return;
    float p[3 * kWavePadding], n[3 * kWavePadding];
    fill_register(columns, row, column + k, p, n);
    std::copy_n(p, 3 * (count - k), position + 3 * k);
    std::copy_n(n, 3 * (count - k), normal + 3 * k);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(fill);

void fill_wave(const WaveColumns& columns, const WaveRow& row, std::size_t column,
    std::size_t count, glm::vec3* position, glm::vec3* normal)
{
    if (count == 0) return;
    HWY_DYNAMIC_DISPATCH(fill)(columns, row, column, count, &position->x, &normal->x);
}

} // namespace firsthit
#endif
