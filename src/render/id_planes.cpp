// id_planes.cpp - the planes that follow from the items: instance, material, node.
#include "render/id_planes.h"

#include "base/large_pages.h"

#include <algorithm>

namespace firsthit {
namespace {

constexpr std::size_t kPixelsPerTask = 16384;

bool contains(const std::vector<Aov>& aovs, Aov wanted)
{
    return std::find(aovs.begin(), aovs.end(), wanted) != aovs.end();
}

/// id_of(instance) of every pixel that sees something.
template <class IdOf>
void fill_plane(const Film& film, Tasks& tasks, std::vector<std::uint32_t>& plane,
    const std::vector<std::uint32_t>& owner, const IdOf& id_of)
{
    resize_in_large_pages(plane, film.item.size());
    tasks.for_ranges(film.item.size(), kPixelsPerTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            plane[k] = film.item[k] == kNoItem ? kNoItem : id_of(owner[film.item[k]]);
    });
}

} // namespace

void IdPlanes::without(const Settings& settings, Settings& own)
{
    own = settings;
    wants_instance_ = contains(settings.aovs, Aov::instance);
    wants_material_ = contains(settings.aovs, Aov::material);
    wants_node_ = contains(settings.aovs, Aov::node);
    wants_item_ = contains(settings.aovs, Aov::item);
    std::erase_if(own.aovs, [](Aov aov) { return holds_ids(aov) && aov != Aov::item; });
    if (!wants_item_ && (wants_instance_ || wants_material_ || wants_node_))
        own.aovs.push_back(Aov::item);
}

void IdPlanes::fill(const Scene& scene, Tasks& tasks, Film& film) const
{
    const std::vector<std::uint32_t>& owner = scene.owner;
    if (wants_instance_)
        fill_plane(
            film, tasks, film.instance, owner, [](std::uint32_t instance) { return instance; });
    if (wants_material_)
        fill_plane(film, tasks, film.material, owner,
            [&](std::uint32_t instance) { return scene.instances[instance].material; });
    if (wants_node_)
        fill_plane(film, tasks, film.node, owner,
            [&](std::uint32_t instance) { return scene.instances[instance].node; });
    if (!wants_item_) film.item.clear();
}

} // namespace firsthit
