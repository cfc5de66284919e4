// item_repair.cpp - repairs the items of one tile of a picture that is nearly right.
//
// Triangles are tested against all samples of a block that need them, as in resolve_tile.cpp. The
// lazy repair of missed samples is rare, and goes sample by sample.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "hits/item_repair.cpp"
#include "base/simd.h"

#include "hits/block_surroundings-inl.h"
#include "hits/item_repair.h"
#include "hits/picture_window.h"
#include "hits/ray_tests-inl.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

/// The repair of one tile.
struct Repair {
    const EyeMesh& mesh;
    const PictureWindow& window;
    TileItems& out;
    std::span<std::uint64_t> holes;
    RayTests tests;
    /// (blocks) bits of the samples for which a triangle was found so far, in the modes full3 and
    /// full5.
    std::uint64_t found[(kMaxTile / kBlock) * (kMaxTile / kBlock)];

    Repair(const EyeMesh& eye_mesh, const PictureWindow& picture, TileItems& tile,
        std::span<std::uint64_t> missed)
        : mesh(eye_mesh),
          window(picture),
          out(tile),
          holes(missed)
    {
    }

    std::uint32_t triangles() const { return std::uint32_t(mesh.index.size()); }
    Effort& effort() { return out.counts.effort; }

    /// Whether triangle a is nearer than b on the ray along d, which hits both, or equally near
    /// with a lower id.
    bool is_nearer(std::uint32_t a, std::uint32_t b, const glm::vec3& d)
    {
        const int order = compare_depth(corners_of(mesh, a), corners_of(mesh, b), d, effort());
        return order < 0 || (order == 0 && a < b);
    }

    /// The samples that hit the triangle of test i where it is there, a bit each.
    std::uint64_t seen_samples(int i)
    {
        const RayTest& test = tests.test[i];
        std::uint64_t hits = hit_samples(tests, i, out, effort());
        if (!mesh.cutouts.has(test.triangle)) return hits;
        for (std::uint64_t rest = hits; rest; rest &= rest - 1)
            if (!mesh.cutouts.is_solid(test.triangle, tests.corners(i),
                    direction_of(out, test.block, std::countr_zero(rest))))
                hits &= ~(rest & (~rest + 1));
        return hits;
    }

    /// Runs the collected tests, and calls use(test, bits of the samples that hit) for each.
    template <class Use>
    void run_tests(const Use& use)
    {
        set_up_tests(mesh, out, tests);
        for (int i = 0; i < tests.count; ++i) use(tests.test[i], seen_samples(i));
        tests.count = 0;
    }

    /// Collects a test, and runs all tests once the batch is full.
    template <class Use>
    void add_test(const RayTest& test, const Use& use)
    {
        tests.test[tests.count] = test;
        if (++tests.count == kRayTests) run_tests(use);
    }

    /// Tests every sample against its own item. Samples that miss become holes.
    void test_own()
    {
        const auto use = [&](const RayTest& test, std::uint64_t hits) {
            holes[test.block] |= test.samples & ~hits;
        };
        for (std::uint32_t block = 0; block < std::uint32_t(out.blocks()); ++block) {
            const std::uint32_t* item = out.item.data() + block * kBlockSamples;
            std::uint64_t rest = ~samples_with(item, kNoItem);
            while (rest) {
                const std::uint32_t id = item[std::countr_zero(rest)];
                const std::uint64_t samples = samples_with(item, id);
                rest &= ~samples;
                if (id < triangles())
                    add_test({id, block, samples}, use);
                else
                    holes[block] |= samples;
            }
        }
        run_tests(use);
    }

    /// The nearest hit among the triangles of the sample's neighbours, or kNoItem.
    std::uint32_t nearest_neighbour(std::uint32_t block, int sample, int reach)
    {
        const glm::vec3 d = direction_of(out, block, sample);
        const int x = int(block) % out.blocks_x() * kBlock + block_x(sample);
        const int y = int(block) / out.blocks_x() * kBlock + block_y(sample);
        std::uint32_t tested[25] = {window.at(x, y)}; // the sample's own item was missed
        int count = 1;
        std::uint32_t best = kNoItem;
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                const std::uint32_t id = window.at(x + dx, y + dy);
                if (id >= triangles() || std::find(tested, tested + count, id) != tested + count)
                    continue;
                tested[count++] = id;
                const Corners corners = corners_of(mesh, id);
                if (!is_hit(corners, d, effort()) || !mesh.cutouts.is_there(id, corners, d))
                    continue;
                if (best == kNoItem || is_nearer(id, best, d)) best = id;
            }
        }
        return best;
    }

    /// Gives holes the nearest hit among their neighbours' triangles. Holes without one get
    /// kNoItem.
    void repair_holes(int reach)
    {
        for (std::uint32_t block = 0; block < std::uint32_t(out.blocks()); ++block) {
            for (std::uint64_t rest = holes[block]; rest; rest &= rest - 1) {
                const int sample = std::countr_zero(rest);
                const std::uint32_t item =
                    reach ? nearest_neighbour(block, sample, reach) : kNoItem;
                out.item[block * kBlockSamples + std::uint32_t(sample)] = item;
                if (item != kNoItem) holes[block] &= ~(std::uint64_t(1) << sample);
            }
        }
    }

    /// Stores the triangle of a test at the samples that hit it and have found no nearer one so
    /// far.
    void keep_nearest(const RayTest& test, std::uint64_t hits)
    {
        std::uint32_t* item = out.item.data() + test.block * kBlockSamples;
        std::uint64_t rivals = hits & found[test.block];
        found[test.block] |= hits;
        for (std::uint64_t rest = hits & ~rivals; rest; rest &= rest - 1)
            item[std::countr_zero(rest)] = test.triangle;
        for (; rivals; rivals &= rivals - 1) {
            const int sample = std::countr_zero(rivals);
            if (is_nearer(test.triangle, item[sample], direction_of(out, test.block, sample)))
                item[sample] = test.triangle;
        }
    }

    /// Tests every sample against all items of its neighbourhood.
    void test_neighbourhoods(int reach)
    {
        const auto use = [&](const RayTest& test, std::uint64_t hits) { keep_nearest(test, hits); };
        for (std::uint32_t block = 0; block < std::uint32_t(out.blocks()); ++block) {
            std::uint32_t* item = out.item.data() + block * kBlockSamples;
            found[block] = 0;
            holes[block] = ~samples_with(item, kNoItem); // samples that had an item
            const int x = int(block) % out.blocks_x() * kBlock;
            const int y = int(block) / out.blocks_x() * kBlock;
            const std::uint64_t inside = window.block_inside(x, y);
            std::fill_n(item, kBlockSamples, kNoItem);
            BlockSurroundings around(window, x, y, reach);
            around.for_each_id([&](std::uint32_t id, std::uint64_t samples) {
                if (id < triangles() && (samples & inside))
                    add_test({id, block, samples & inside}, use);
            });
        }
        run_tests(use);
        for (std::uint32_t block = 0; block < std::uint32_t(out.blocks()); ++block)
            holes[block] &= ~found[block];
    }

    /// Makes samples holes whose id is no triangle.
    void check_ids()
    {
        const hn::CappedTag<std::uint32_t, 16> d;
        const auto end = hn::Set(d, triangles()), none = hn::Set(d, kNoItem);
        for (std::size_t block = 0; block < std::size_t(out.blocks()); ++block) {
            for (std::size_t k = 0; k < kBlockSamples; k += hn::Lanes(d)) {
                std::uint32_t* item = out.item.data() + block * kBlockSamples + k;
                const auto id = hn::Load(d, item);
                const auto wrong = hn::Not(hn::Or(hn::Lt(id, end), hn::Eq(id, none)));
                holes[block] |= bits_of(d, wrong) << k;
                hn::Store(hn::IfThenElse(wrong, none, id), d, item);
            }
        }
    }
};

void repair(const EyeMesh& mesh, const PictureWindow& window, Multisample mode, TileItems& out,
    std::span<std::uint64_t> holes)
{
    Repair work(mesh, window, out, holes);
    window.copy(out);
    switch (mode) {
    case Multisample::none:
    case Multisample::lazy3:
    case Multisample::lazy5:
        work.test_own();
        work.repair_holes(reach_of(mode));
        break;
    case Multisample::full3:
    case Multisample::full5:
        work.test_neighbourhoods(reach_of(mode));
        break;
    case Multisample::exact:
        work.check_ids();
        break;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(repair);

void repair_tile_items(const EyeMesh& mesh, const PictureTile& picture, Multisample mode,
    TileItems& out, std::span<std::uint64_t> holes)
{
    const TileLayout& layout = picture.layout;
    out.rays = layout.rays(picture.tile);
    out.counts = {};
    const PictureWindow window(picture.picture, layout.pencil.width, layout.pencil.height,
        layout.first_x(picture.tile), layout.first_y(picture.tile));
    HWY_DYNAMIC_DISPATCH(repair)(mesh, window, mode, out, holes);
}

} // namespace firsthit
#endif
