// fuzz_mtl.cpp - material libraries made of anything, as materials of a scene.
#include "readers/mesh/mtl/mtl_material.h"

#include "scene/model/check_scene.h"

#include <firsthit/error.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace {

/// A triangle with each material of a library, whose textures are nowhere.
void make_scene(std::string_view text)
{
    using namespace firsthit;
    Problems problems;
    const std::vector<MtlMaterial> library = read_mtl(text, "fuzz", problems);
    SceneBuilder scene("fuzz");
    const std::uint32_t node = scene.add_node({.name = "node"});
    MtlTextures textures(scene);
    textures.set_folder("no/such/folder");
    for (const MtlMaterial& mtl : library) {
        MtlMeshNeeds needs;
        const MtlSettings settings{.physical = mtl.is_physical(), .has_uv = true};
        const std::uint32_t material =
            scene.add_material(make_material(mtl, settings, textures, needs));
        Mesh mesh;
        mesh.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.normal.assign(3, {0, 0, 1});
        mesh.uv = {{0, 0}, {1, 0}, {0, 1}};
        mesh.index = {{0, 1, 2}};
        needs.apply(mesh);
        scene.add_instance(scene.add_mesh(std::move(mesh)), node, material);
    }
    const Scene made = scene.build();
    if (!library.empty()) check_scene(made);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        make_scene({reinterpret_cast<const char*>(data), size});
    } catch (const firsthit::Error&) {
        // Refused with a reason, as UTF-16 is.
    }
    return 0;
}
