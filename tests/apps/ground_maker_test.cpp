// ground_maker_test.cpp - the floor of --ground in pictures.
#include "inputs/ground_maker.h"
#include "common/usage.h"

#include "message_of.h"

#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace firsthit::cli {
namespace {

/// A picture as `firsthit render` makes it, and what it sees.
struct GroundPicture {
    Film film;
    std::shared_ptr<const Scene> scene;

    explicit GroundPicture(const std::string& line)
    {
        RenderOptions options;
        CLI::App app("test", "render");
        add_render_options(app, options);
        app.parse(line);
        Scene read = load_scene(options.scene.name);
        if (wants_studio(options.sky, read, false)) apply_studio(options.sky, read);
        apply(options.picture.backdrop, read);
        std::optional<ViewMaker> views;
        GroundMaker ground(options, views);
        if (options.ground.wanted) ground.add(read);
        if (!views) views.emplace(options.camera, options.scene.name);
        scene = std::make_shared<const Scene>(std::move(read));
        World world;
        pose(scene, PoseSettings{}, world);
        Settings settings;
        settings.aovs = {Aov::item, Aov::lit, Aov::depth};
        apply(options.sky, true, settings);
        Renderer renderer(1);
        renderer.render(world, views->view(world), settings, film);
    }

    glm::vec3 color(std::size_t pixel) const
    {
        return {film.color.value[3 * pixel], film.color.value[3 * pixel + 1],
            film.color.value[3 * pixel + 2]};
    }
};

const std::string kLine = "builtin:torus -o a.png --size 96x72 --view iso --studio on --sky 32";

TEST(GroundMaker, LeavesTheModelWhereItIsAndHidesNoneOfIt)
{
    const GroundPicture without(kLine), with(kLine + " --ground");
    const std::uint32_t triangles = std::uint32_t(without.scene->triangle_count());
    for (std::size_t k = 0; k < without.film.item.size(); ++k) {
        if (without.film.item[k] == kNoItem) continue;
        EXPECT_EQ(with.film.item[k], without.film.item[k]);
        EXPECT_EQ(with.film[Aov::depth].value[k], without.film[Aov::depth].value[k]);
    }
    EXPECT_EQ(std::count_if(with.film.item.begin(), with.film.item.end(),
                  [&](std::uint32_t id) { return id == kNoItem; }),
        0)
        << "seen from above, the floor is everywhere";
    EXPECT_EQ(with.scene->triangle_count(), triangles + 2);
}

TEST(GroundMaker, LooksAsTheBackgroundWhereNothingShadowsIt)
{
    const GroundPicture with(kLine + " --ground");
    const glm::vec3 background = with.scene->background;
    const std::uint32_t triangles = std::uint32_t(with.scene->triangle_count()) - 2;
    int darker = 0;
    for (std::size_t k = 0; k < with.film.item.size(); ++k) {
        if (with.film.item[k] < triangles) continue;
        EXPECT_LE(with.color(k).y, background.y * 1.01f);
        darker += with.color(k).y < 0.7f * background.y;
    }
    for (const std::size_t corner :
        {std::size_t(0), std::size_t(95), std::size_t(71 * 96), std::size_t(72 * 96 - 1)})
        EXPECT_NEAR(with.color(corner).y, background.y, 0.03f * background.y) << corner;
    EXPECT_GT(darker, 100) << "there is no shadow";
}

TEST(GroundMaker, GivesTheFloorAColorOfItsOwn)
{
    const GroundPicture with(kLine + " --ground 0.5,0.05,0.05");
    const glm::vec3 corner = with.color(0);
    EXPECT_GT(corner.x, 4 * corner.y);
}

TEST(GroundMaker, RefusesWhatIsNoColor)
{
    RenderOptions options;
    CLI::App app("test", "render");
    add_render_options(app, options);
    for (const char* text : {"1,2,3", "-1,0,0", "red", "0.5", "nan,0,0"})
        EXPECT_NE(message_of<UsageError>([&] {
            app.parse("s -o a.png --ground " + std::string(text));
        }).find("accepted are R,G,B"),
            std::string::npos)
            << text;
    app.clear();
}

} // namespace
} // namespace firsthit::cli
