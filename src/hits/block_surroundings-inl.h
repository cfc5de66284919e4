// block_surroundings-inl.h - the items in and around a block: which are near which of its samples?
#if defined(FIRSTHIT_HITS_BLOCK_SURROUNDINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_HITS_BLOCK_SURROUNDINGS_INL_H_
#undef FIRSTHIT_HITS_BLOCK_SURROUNDINGS_INL_H_
#else
#define FIRSTHIT_HITS_BLOCK_SURROUNDINGS_INL_H_
#endif

#include "hits/item_runs-inl.h"
#include "hits/picture_window.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Reorders the bits of a block's samples from row by row to the order of base/tile_order.h.
HWY_INLINE std::uint64_t block_order(std::uint64_t rows)
{
    // Gathers the lower four bits of each byte: 16 consecutive bits for each four rows.
    const auto halves = [](std::uint64_t v) {
        v &= 0x0F0F0F0F0F0F0F0F;
        v = (v | v >> 4) & 0x00FF00FF00FF00FF;
        return (v | v >> 8) & 0x0000FFFF0000FFFF;
    };
    return halves(rows) | halves(rows >> 4) << 16;
}

/// The items of a block and of `reach` rows and columns around it.
class BlockSurroundings {
  public:
    /// x, y   the block's first sample, in the window's coordinates
    /// reach  0 to 2
    BlockSurroundings(const PictureWindow& window, int x, int y, int reach)
        : reach_(reach),
          side_(kBlock + 2 * reach)
    {
        for (int row = 0; row < side_; ++row)
            window.copy_row(x - reach, y - reach + row, side_, item_[row]);
    }

    /// Calls f(id, samples) for each distinct id except kNoItem. `samples` has a bit for each
    /// sample of the block that has the id in its neighbourhood.
    template <class F>
    void for_each_id(const F& f) const
    {
        std::uint32_t rest[kRows]; // bits of the columns of each row whose id is still to come
        std::uint32_t same[kRows];
        find(0, kNoItem, rest);
        for (int row = 0; row < side_; ++row) rest[row] = ~rest[row] & ((1u << side_) - 1);
        for (int row = 0; row < side_; ++row) {
            while (rest[row]) {
                const std::uint32_t id = item_[row][std::countr_zero(rest[row])];
                find(row, id, same);
                std::uint64_t near = 0;
                for (int k = row; k < side_; ++k) {
                    rest[k] &= ~same[k];
                    if (same[k]) near |= near_row(k, same[k]);
                }
                f(id, block_order(near));
            }
        }
    }

  private:
    static constexpr int kRows = kBlock + 4;
    static constexpr int kColumns = 16; // a row has room in one register, or in whole ones

    /// Finds the columns with that id, a bit each, in the rows from `first` on.
    HWY_INLINE void find(int first, std::uint32_t id, std::uint32_t* columns) const
    {
        const hn::CappedTag<std::uint32_t, kColumns> d;
        const auto wanted = hn::Set(d, id);
        for (int row = first; row < side_; ++row) {
            std::uint64_t found = 0;
            for (int k = 0; k < side_; k += int(hn::Lanes(d)))
                found |= bits_of(d, hn::Eq(hn::Load(d, item_[row] + k), wanted)) << k;
            columns[row] = std::uint32_t(found) & ((1u << side_) - 1);
        }
    }

    /// The samples of the block, a byte for each row, that have one of the columns of the row in
    /// their neighbourhood.
    HWY_INLINE std::uint64_t near_row(int row, std::uint32_t columns) const
    {
        std::uint32_t wide = 0; // sample x is near the columns x to x + 2 reach
        for (int k = 0; k <= 2 * reach_; ++k) wide |= columns >> k;
        const int first = std::max(row - 2 * reach_, 0), last = std::min(row, kBlock - 1);
        std::uint64_t near = 0;
        for (int y = first; y <= last; ++y) near |= std::uint64_t(wide & 0xFF) << (8 * y);
        return near;
    }

    int reach_, side_;
    alignas(64) std::uint32_t item_[kRows][kColumns]; // columns from side_ on are undefined
};

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
