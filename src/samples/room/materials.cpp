// materials.cpp - what the room's things are made of.
#include "samples/room/materials.h"

#include "samples/room/textures/textures.h"

#include <string>
#include <utility>

namespace firsthit {
namespace {

/// Highlights of a surface: their strength, which mirrors reflect with, and how narrow they are.
struct Gloss {
    float strength = 0.03f;
    float shininess = 10;
};

/// The share of light that comes from everywhere: what walls would pass on.
constexpr float kRoomAmbient = 0.30f;

class MaterialMaker {
  public:
    explicit MaterialMaker(SceneBuilder& builder) : builder_(builder) {}

    std::uint32_t add(const char* name, const Phong& model)
    {
        Material made;
        made.name = name;
        made.model = model;
        return builder_.add_material(std::move(made));
    }

    std::uint32_t plain(const char* name, const glm::vec3& color, const Gloss& gloss = {})
    {
        return add(name, {.ambient = kRoomAmbient * color,
                             .diffuse = color,
                             .specular = glm::vec3(gloss.strength),
                             .shininess = gloss.shininess});
    }

    /// ambient  the share of light from everywhere; thin cloth before a window has more
    std::uint32_t textured(Texture texture, const Gloss& gloss = {}, float ambient = kRoomAmbient)
    {
        const std::string name = texture.name();
        Phong model{.ambient = glm::vec3(ambient),
            .diffuse = glm::vec3(1),
            .specular = glm::vec3(gloss.strength),
            .shininess = gloss.shininess};
        model.texture = static_cast<std::int32_t>(builder_.add_texture(std::move(texture)));
        return add(name.c_str(), model);
    }

    /// Bright also where no light reaches it.
    std::uint32_t glowing(const char* name, const glm::vec3& color, float glow)
    {
        return add(name, {.ambient = glow * color, .diffuse = color});
    }

  private:
    SceneBuilder& builder_;
};

void add_cloths(MaterialMaker& make, RoomMaterials& materials)
{
    materials.rug = make.textured(make_rug());
    materials.fringe = make.plain("fringe", {0.62f, 0.54f, 0.40f});
    materials.linen = make.textured(make_cloth("linen", {0.78f, 0.74f, 0.66f}), {}, 0.55f);
    materials.mustard = make.textured(make_cloth("mustard", {0.62f, 0.36f, 0.07f}));
    materials.cushion = make.textured(make_cloth("cushion", {0.10f, 0.27f, 0.30f}));
}

/// What later versions mirror and refract.
void add_clear_things(MaterialMaker& make, RoomMaterials& materials)
{
    materials.chrome = make.add("chrome", {.ambient = {0.10f, 0.10f, 0.11f},
                                              .diffuse = {0.26f, 0.27f, 0.29f},
                                              .specular = glm::vec3(0.75f),
                                              .shininess = 60});
    materials.mirror = make.add("mirror", {.ambient = {0.10f, 0.12f, 0.13f},
                                              .diffuse = {0.16f, 0.19f, 0.20f},
                                              .specular = glm::vec3(0.85f),
                                              .shininess = 300});
    materials.glass = make.add("glass", {.ambient = {0.16f, 0.22f, 0.22f},
                                            .diffuse = {0.42f, 0.55f, 0.55f},
                                            .specular = glm::vec3(0.35f),
                                            .shininess = 120,
                                            .transmittance = 0.9f,
                                            .ior = 1.5f});
}

} // namespace

RoomMaterials add_room_materials(SceneBuilder& builder)
{
    MaterialMaker make(builder);
    RoomMaterials materials;
    materials.floor = make.textured(make_planks(), {0.10f, 25});
    materials.wall = make.textured(make_plaster("plaster", {0.72f, 0.66f, 0.55f}));
    materials.accent_wall = make.textured(make_plaster("accent plaster", {0.20f, 0.33f, 0.31f}));
    materials.ceiling = make.plain("ceiling", {0.80f, 0.78f, 0.74f});
    materials.white = make.plain("white paint", {0.78f, 0.77f, 0.73f}, {0.08f, 20});
    materials.walnut = make.textured(make_wood("walnut", {0.22f, 0.11f, 0.05f}), {0.12f, 30});
    materials.oak = make.textured(make_wood("oak", {0.46f, 0.29f, 0.14f}), {0.08f, 20});
    materials.birch = make.textured(make_wood("birch", {0.66f, 0.50f, 0.31f}), {0.06f, 20});
    add_cloths(make, materials);

    materials.wicker = make.plain("wicker", {0.50f, 0.31f, 0.13f}, {0.10f, 15});
    materials.leaf = make.plain("leaf", {0.09f, 0.27f, 0.06f}, {0.12f, 25});
    materials.bark = make.plain("bark", {0.20f, 0.13f, 0.07f});
    materials.soil = make.plain("soil", {0.06f, 0.04f, 0.03f});
    materials.clay = make.plain("clay", {0.48f, 0.20f, 0.10f});

    materials.books = make.textured(make_bindings(), {0.06f, 15});
    materials.paper = make.plain("paper", {0.75f, 0.70f, 0.58f});
    materials.landscape = make.textured(make_landscape());
    materials.poster = make.textured(make_poster());

    materials.porcelain = make.plain("porcelain", {0.80f, 0.79f, 0.75f}, {0.25f, 60});
    materials.blue_glaze = make.plain("blue glaze", {0.07f, 0.19f, 0.42f}, {0.25f, 60});
    materials.tea = make.plain("tea", {0.22f, 0.08f, 0.02f}, {0.2f, 60});
    materials.apple = make.plain("apple", {0.56f, 0.07f, 0.04f}, {0.15f, 35});
    materials.orange = make.plain("orange", {0.80f, 0.33f, 0.03f}, {0.10f, 20});

    materials.brass = make.plain("brass", {0.56f, 0.38f, 0.13f}, {0.35f, 40});
    materials.iron = make.plain("iron", {0.05f, 0.05f, 0.055f}, {0.15f, 25});
    add_clear_things(make, materials);
    materials.shade = make.glowing("lampshade", {0.90f, 0.74f, 0.48f}, 0.75f);
    materials.bulb = make.glowing("bulb", {1.0f, 0.92f, 0.75f}, 1.0f);
    materials.lantern_paper = make.glowing("lantern", {0.95f, 0.60f, 0.28f}, 0.8f);

    materials.car_red = make.plain("car red", {0.62f, 0.04f, 0.03f}, {0.30f, 50});
    materials.car_cream = make.plain("car cream", {0.76f, 0.68f, 0.50f}, {0.25f, 50});
    materials.rubber = make.plain("rubber", {0.035f, 0.035f, 0.04f}, {0.08f, 12});
    materials.headlight = make.glowing("headlight", {1.0f, 0.95f, 0.75f}, 0.8f);
    materials.toys = {make.plain("toy red", {0.62f, 0.08f, 0.06f}, {0.12f, 25}),
        make.plain("toy yellow", {0.78f, 0.50f, 0.05f}, {0.12f, 25}),
        make.plain("toy blue", {0.05f, 0.20f, 0.50f}, {0.12f, 25}),
        make.plain("toy green", {0.10f, 0.38f, 0.14f}, {0.12f, 25})};
    return materials;
}

} // namespace firsthit
