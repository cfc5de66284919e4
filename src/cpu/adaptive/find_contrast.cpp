// find_contrast.cpp - finds the pixels whose colour stands out from a line of three.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/adaptive/find_contrast.cpp"
#include "base/simd.h"

#include "cpu/adaptive/active_runs.h"
#include "cpu/adaptive/edge_finder.h"
#include "shade/shade_environment.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#ifndef FIRSTHIT_FIND_CONTRAST_ONCE
#define FIRSTHIT_FIND_CONTRAST_ONCE
namespace firsthit {

/// Colours of a row as codes, each channel by itself, and what is seen there. A pixel more lies on either
/// side.
struct CodedRow {
    float* channel[3];
    std::uint32_t* kind;
    std::uint32_t* lit;
};

/// The borders of shadows count so many times: what is added to a colour may end there.
inline constexpr float kShadowBend = 3;

} // namespace firsthit
#endif

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using ContrastTag = hn::ScalableTag<float>;

/// Codes `count` colours: about 8-bit sRGB, but without an end, and quickly computed. Light that is
/// negative, NaN or above 1e30 counts as none.
void code_colors(const float* HWY_RESTRICT rgb, std::size_t count, const CodedRow& to)
{
    const ContrastTag d;
    const auto code = [&](auto linear) {
        const auto good = hn::And(hn::Gt(linear, hn::Zero(d)), hn::Lt(linear, hn::Set(d, 1e30f)));
        return hn::Mul(hn::Set(d, 255.0f), hn::Sqrt(hn::IfThenElseZero(good, linear)));
    };
    std::size_t k = 0;
    for (; k + hn::Lanes(d) <= count; k += hn::Lanes(d)) {
        auto r = hn::Zero(d), g = r, b = r;
        hn::LoadInterleaved3(d, rgb + 3 * k, r, g, b);
        hn::StoreU(code(r), d, to.channel[0] + k);
        hn::StoreU(code(g), d, to.channel[1] + k);
        hn::StoreU(code(b), d, to.channel[2] + k);
    }
    const hn::CappedTag<float, 1> one;
    for (; k < count; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float linear = rgb[3 * k + c];
            const float good = linear > 0 && linear < 1e30f ? linear : 0.0f;
            to.channel[c][k] = 255.0f * hn::GetLane(hn::Sqrt(hn::Set(one, good)));
        }
    }
}

/// By how much the middle of each pixel's opposite neighbours is off its colour, twice, at most; only of
/// neighbours that see the same instance, and kShadowBend times as much where other lights reach them.
///
/// rows  above, of the pixels and below, from their first one
/// bend  (count), with room for a register more
void find_bends(const CodedRow (&rows)[3], std::size_t count, float* HWY_RESTRICT bend)
{
    const ContrastTag d;
    const hn::RebindToUnsigned<ContrastTag> du;
    const CodedRow &up = rows[0], &row = rows[1], &down = rows[2];
    for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
        const auto kind = hn::LoadU(du, row.kind + k), lit = hn::LoadU(du, row.lit + k);
        auto most = hn::Zero(d);
        const auto add = [&](const CodedRow& a, std::ptrdiff_t at_a, const CodedRow& b,
                             std::ptrdiff_t at_b) {
            auto bent = hn::Zero(d);
            for (int c = 0; c < 3; ++c) {
                const auto middle =
                    hn::Add(hn::LoadU(d, a.channel[c] + at_a), hn::LoadU(d, b.channel[c] + at_b));
                const auto own = hn::LoadU(d, row.channel[c] + k);
                bent = hn::Max(bent, hn::Abs(hn::Sub(middle, hn::Add(own, own))));
            }
            const auto differ = [&](const std::uint32_t* p, const std::uint32_t* q, auto own) {
                return hn::Or(hn::Xor(hn::LoadU(du, p), own), hn::Xor(hn::LoadU(du, q), own));
            };
            const auto other = differ(a.kind + at_a, b.kind + at_b, kind);
            const auto shadow = differ(a.lit + at_a, b.lit + at_b, lit);
            const auto is = [&](auto v) { return hn::RebindMask(d, hn::Eq(v, hn::Zero(du))); };
            bent = hn::IfThenElse(is(shadow), bent, hn::Mul(bent, hn::Set(d, kShadowBend)));
            most = hn::Max(most, hn::IfThenElseZero(is(other), bent));
        };
        const auto at = std::ptrdiff_t(k);
        add(row, at - 1, row, at + 1);
        add(up, at, down, at);
        add(up, at - 1, down, at + 1);
        add(up, at + 1, down, at - 1);
        hn::StoreU(most, d, bend + k);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(code_colors);
HWY_EXPORT(find_bends);

namespace {

/// Two opposite neighbours whose middle differs by more than half of this from the colour between
/// them, in 8-bit codes, are an edge.
constexpr float kMostBend = 6;

/// The same on a surface with textures. These are filtered already, so that they only become sharper by
/// more samples, and that at most pixels.
constexpr float kMostTextureBend = 8;

/// Rows of a run of pixels and of one more pixel on each side, coded. At the picture's border a row stands
/// for the missing one, and a pixel for the missing neighbour.
class CodedRows {
  public:
    /// memory  is kept from call to call
    CodedRows(const Plane& color, const EdgeSight& picture, const Region& all, const PixelRun& run,
        EdgeMemory::Worker& memory)
        : color_(color.value.data()),
          picture_(picture),
          width_(all.width),
          height_(all.height),
          run_(run),
          padded_(std::size_t(run.end - run.begin) + 2 + kSpare),
          memory_(memory)
    {
        memory.color.resize(std::max(memory.color.size(), 3 * padded_ * kSlots));
        memory.numbers.resize(std::max(memory.numbers.size(), 2 * padded_ * kSlots));
        memory.bend.resize(std::max(memory.bend.size(), padded_));
    }

    /// Codes row y, which is kept until row y + 3 is coded.
    void code(int y)
    {
        const std::size_t from = std::size_t(std::clamp(y, 0, height_ - 1)) * std::size_t(width_);
        const CodedRow to = row(y);
        const auto first = std::size_t(std::max(run_.begin - 1, 0)),
                   last = std::size_t(std::min(run_.end + 1, width_));
        const std::ptrdiff_t at = std::ptrdiff_t(first) - run_.begin;
        HWY_DYNAMIC_DISPATCH(code_colors)
        (color_ + 3 * (from + first), last - first,
            {{to.channel[0] + at, to.channel[1] + at, to.channel[2] + at}, nullptr, nullptr});
        std::copy(&picture_.kind[from] + first, &picture_.kind[from] + last, to.kind + at);
        std::copy(&picture_.lit[from] + first, &picture_.lit[from] + last, to.lit + at);
        const auto repeat = [&](std::ptrdiff_t missing, std::ptrdiff_t there) {
            for (float* channel : to.channel) channel[missing] = channel[there];
            to.kind[missing] = to.kind[there];
            to.lit[missing] = to.lit[there];
        };
        const std::ptrdiff_t end = run_.end - run_.begin;
        if (run_.begin == 0) repeat(-1, 0);
        if (run_.end == width_) repeat(end, end - 1);
    }

    CodedRow row(int y)
    {
        const std::size_t slot = std::size_t(y + 3) % kSlots;
        const auto channel = [&](std::size_t c) {
            return memory_.color.data() + (3 * slot + c) * padded_ + 1;
        };
        const auto numbers = [&](std::size_t which) {
            return memory_.numbers.data() + (2 * slot + which) * padded_ + 1;
        };
        return {{channel(0), channel(1), channel(2)}, numbers(0), numbers(1)};
    }

  private:
    static constexpr std::size_t kSlots = 3;
    static constexpr std::size_t kSpare = 16; // a register more is read and written

    const float* color_;
    const EdgeSight& picture_;
    int width_, height_;
    PixelRun run_;
    std::size_t padded_;
    EdgeMemory::Worker& memory_;
};

} // namespace

void EdgeFinder::find_contrast(const Plane& color)
{
    const Region& region = marks_.region;
    const bool all = shows_environment(*world_.scene);
    for_active_runs(
        tasks_, memory_.first, region, all, [&](const PixelRun& run, std::size_t worker) {
            EdgeMemory::Worker& own = memory_.worker[worker];
            CodedRows rows(color, memory_.first, region, run, own);
            rows.code(run.top - 1);
            rows.code(run.top);
            for (int y = run.top; y < run.bottom; ++y) {
                rows.code(y + 1);
                const CodedRow three[3] = {rows.row(y - 1), rows.row(y), rows.row(y + 1)};
                HWY_DYNAMIC_DISPATCH(find_bends)
                (three, std::size_t(run.end - run.begin), own.bend.data());
                for (int x = run.begin; x < run.end; ++x) {
                    const std::size_t at = std::size_t(x - run.begin);
                    if (own.bend[at] <= kMostBend) continue;
                    if (own.bend[at] > kMostTextureBend || !(three[1].kind[at] & 1))
                        marks_.mark(region.x + x, region.y + y);
                }
            }
        });
}

} // namespace firsthit
#endif
