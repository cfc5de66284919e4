// pictures.cpp - the pictures of the paper's figures 2, 4, 7 and 10, and of its scenes.
#include "bench/paper/pictures.h"

#include "bench/paper/densest_window.h"
#include "bench/paper/numbers.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace firsthit::cli::bench {

namespace {

constexpr std::size_t kRobots = 0, kBunny = 1;

/// Renders squares and shows them.
struct Studio {
    const std::vector<PaperScene>& scenes;
    int side;
    Renderer renderer;
    World world;

    /// The middle of the animation.
    Film film(std::size_t scene, Settings settings)
    {
        settings.aovs = {Aov::item};
        const std::shared_ptr<const Scene>& shown = scenes[scene].scene;
        renderer.pose(shown, frame_time(*shown, 0, 1), world);
        Film film;
        renderer.render(world, view_of(scenes[scene], world, {side, side}), settings, film);
        return film;
    }
};

/// A part of a picture as large on the page as the picture.
Picture extract(const Picture& picture, const Region& part)
{
    return enlarged(picture, part, std::max(1, picture.width / std::max(1, part.width)));
}

Settings cpu_exact(int samples)
{
    Settings settings;
    settings.samples = samples;
    return settings;
}

void show_scenes(Studio& studio, Report& report)
{
    std::vector<Page::Shown> shown;
    for (std::size_t k = 0; k < studio.scenes.size(); ++k)
        if (studio.scenes[k].scene)
            shown.push_back({picture_of(studio.film(k, cpu_exact(2))), kPaperNames[k]});
    report.page.add_pictures(
        "scenes", shown, "The scenes with one light: cpu engine, exact shadows, 2x2 rays a pixel.");
}

void show_items(Studio& studio, Report& report)
{
    const Film film = studio.film(kRobots, cpu_exact(1));
    report.page.add_pictures("figure2",
        {{picture_of(film), "the framebuffer"}, {picture_of_items(film), "the item buffer"}},
        "Figure 2: the item buffer (right) has the index of the triangle that each pixel of the "
        "framebuffer "
        "(left) sees; here every index has a colour of its own, and black is none. cpu engine.");
}

void show_interleaving(Studio& studio, Report& report)
{
    Settings settings = paper_way("cpu interleaved").settings;
    const Film blurred = studio.film(kRobots, settings);
    settings.interleave = 1;
    const Film sharp = studio.film(kRobots, settings);
    // Where it shows most.
    std::vector<std::uint8_t> differs(sharp.item.size());
    for (std::size_t k = 0; k < differs.size(); ++k) {
        float most = 0;
        for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
            most = std::max(most, std::abs(sharp.color.value[c] - blurred.color.value[c]));
        differs[k] = most > 0.05f;
    }
    const Region part = densest_window(differs, sharp.width, std::max(8, studio.side / 4));
    report.page.add_pictures("figure7",
        {{extract(picture_of(blurred), part), "interleaved"},
            {extract(picture_of(sharp), part), "normal"}},
        fmt::format(
            "Figure 7: interleaved rendering (left), where the ray of one pixel in {} is shot and "
            "the pixels "
            "between are interpolated, and normal rendering (right); an extract of the robots, "
            "enlarged.",
            kPaperInterleave));
}

/// Pixels where the cpu engine sees a triangle and this film has none.
std::vector<std::uint8_t> holes(const Film& film, const Film& exact)
{
    std::vector<std::uint8_t> hole(film.item.size());
    for (std::size_t k = 0; k < hole.size(); ++k)
        hole[k] = film.item[k] == kNoItem && exact.item[k] != kNoItem;
    return hole;
}

/// With the marked pixels in magenta.
Picture with_marks(Picture picture, std::span<const std::uint8_t> marks)
{
    constexpr std::array<std::uint8_t, 3> kMagenta = {255, 0, 255};
    for (std::size_t k = 0; k < marks.size(); ++k)
        if (marks[k]) std::copy(kMagenta.begin(), kMagenta.end(), &picture.rgb[3 * k]);
    return picture;
}

/// Figures 4 and 10: the same extract without and with multisampling.
struct Artefacts {
    const char* key;
    std::size_t scene;
    bool interpolate; // in the second picture
    const char* left;
    const char* right;
    const char* caption;
};

void show_artefacts(Studio& studio, const Artefacts& asked, Report& report, Json& json)
{
    if (!studio.scenes[asked.scene].scene) {
        report.page.paragraph(fmt::format("{} {}", asked.caption, studio.scenes[asked.scene].note));
        json[asked.key] = {{"unavailable", studio.scenes[asked.scene].note}};
        return;
    }
    try {
        Settings settings = paper_way("hybrid").settings;
        settings.interpolate = false;
        const Film bare = studio.film(asked.scene, settings);
        const std::uint64_t missed_bare = studio.renderer.stats().missed;
        settings.multisample = Multisample::full3;
        settings.interpolate = asked.interpolate;
        const Film repaired = studio.film(asked.scene, settings);
        const std::uint64_t missed_repaired = studio.renderer.stats().missed;
        const Film exact = studio.film(asked.scene, paper_way("cpu").settings);
        const std::vector<std::uint8_t> bare_holes = holes(bare, exact);
        Picture right = picture_of(repaired);
        if (!asked.interpolate) right = with_marks(std::move(right), holes(repaired, exact));
        const Region part = densest_window(bare_holes, bare.width, std::max(8, studio.side / 5));
        report.page.add_pictures(asked.key,
            {{extract(with_marks(picture_of(bare), bare_holes), part),
                 fmt::format("{}; pixels missed: {}", asked.left, missed_bare)},
                {extract(right, part),
                    fmt::format("{}; pixels missed: {}", asked.right, missed_repaired)}},
            fmt::format("{} An extract, enlarged; missed pixels without a colour are magenta. The "
                        "counts are of "
                        "the whole picture of {}x{}, made by the hybrid engine. The cpu engine "
                        "misses none.",
                asked.caption, studio.side, studio.side));
        json[asked.key] = {{"pixels", studio.side * studio.side}, {"missed", missed_bare},
            {"missed_3x3", missed_repaired}};
    } catch (const DeviceError& error) {
        report.page.paragraph(fmt::format("{} {}", asked.caption, error.what()));
        json[asked.key] = {{"unavailable", error.what()}};
    }
}

} // namespace

void add_paper_pictures(
    const std::vector<PaperScene>& scenes, int side, int threads, Report& report, Json& json)
{
    Studio studio{.scenes = scenes, .side = side, .renderer = Renderer(threads), .world = {}};
    show_scenes(studio, report);
    show_items(studio, report);
    show_artefacts(studio,
        {.key = "figure4",
            .scene = kRobots,
            .interpolate = false,
            .left = "no multisampling",
            .right = "3x3 multisampling",
            .caption =
                "Figure 4: artefacts without multisampling, almost none with 3x3; the robots."},
        report, json);
    show_interleaving(studio, report);
    show_artefacts(studio,
        {.key = "figure10",
            .scene = kBunny,
            .interpolate = true,
            .left = "no multisampling, no interpolation",
            .right = "3x3 multisampling and interpolation",
            .caption = "Figure 10: a mesh of tiny triangles, without multisampling and "
                       "interpolation, and with "
                       "both; the bunny."},
        report, json);
}

} // namespace firsthit::cli::bench
