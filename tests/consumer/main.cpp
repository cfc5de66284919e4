// main.cpp - renders a torus, counts what is seen, writes a picture.
#include <firsthit/firsthit.h>

#include <algorithm>
#include <cstdio>

int main()
{
    firsthit::World world;
    firsthit::pose(firsthit::load_scene("builtin:torus"), 0.0, world);

    firsthit::View view;
    view.camera = firsthit::framing_camera(world);
    view.width = 320;
    view.height = 240;

    firsthit::Settings settings;
    settings.aovs = {firsthit::Aov::item, firsthit::Aov::depth};
    firsthit::Renderer renderer;
    firsthit::Film film;
    renderer.render(world, view, settings, film);

    const auto empty = std::count(film.item.begin(), film.item.end(), firsthit::kNoItem);
    std::printf("%td of %zu pixels see the torus\n",
        static_cast<std::ptrdiff_t>(film.item.size()) - empty, film.item.size());
    firsthit::write_color(film, "torus.png");
    return empty < static_cast<std::ptrdiff_t>(film.item.size()) ? 0 : 1;
}
