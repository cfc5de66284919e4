// read_materials.cpp - the materials of a glTF document, with the extensions that are supported.
#include "readers/gltf/document/loader.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace firsthit::gltf {
namespace {

class MaterialReader {
  public:
    MaterialReader(Loader& loader, const Place& place) : loader_(loader), place_(place) {}

    Material read()
    {
        material_.name = place_.text("name");
        read_core();
        read_extensions();
        return std::move(material_);
    }

  private:
    TextureInfo texture(const Place& place, const char* key) const
    {
        TextureInfo info;
        const std::optional<Place> found = place.find(key);
        if (!found) return info;
        info.texture = found->required_index("index", loader_.document.textures.size());
        info.tex_coord = int(found->size("texCoord", 0, kMaxTexCoord));
        if (const std::optional<Place> moved = found->extension("KHR_texture_transform")) {
            info.offset = vec2(*moved, "offset", info.offset);
            info.rotation_rad = moved->number("rotation", 0.0f);
            info.scale = vec2(*moved, "scale", info.scale);
            info.tex_coord =
                int(moved->size("texCoord", std::size_t(info.tex_coord), kMaxTexCoord));
        }
        return info;
    }

    /// The scale or strength that stands in a texture's info.
    static float in_texture(const Place& place, const char* texture, const char* key)
    {
        const std::optional<Place> found = place.find(texture);
        return found ? found->number(key, 1.0f) : 1.0f;
    }

    static glm::vec2 vec2(const Place& place, const char* key, glm::vec2 value)
    {
        std::array<float, 2> numbers{};
        if (place.numbers(key, numbers)) value = {numbers[0], numbers[1]};
        return value;
    }

    static glm::vec3 vec3(const Place& place, const char* key, glm::vec3 value)
    {
        std::array<float, 3> numbers{};
        if (place.numbers(key, numbers)) value = {numbers[0], numbers[1], numbers[2]};
        return value;
    }

    static glm::vec4 vec4(const Place& place, const char* key, glm::vec4 value)
    {
        std::array<float, 4> numbers{};
        if (place.numbers(key, numbers)) value = {numbers[0], numbers[1], numbers[2], numbers[3]};
        return value;
    }

    /// A value outside its range is moved to the nearest that is allowed.
    void keep_within(float& value, float least, float most, const char* what)
    {
        if (value >= least && value <= most) return;
        loader_.warn(
            std::string("range ") + what, fmt::format("{}: {} is {}, {} is used", place_.path(),
                                              what, value, value < least ? least : most));
        value = value < least ? least : most;
    }
    template <class Vector>
    void keep_all_within(Vector& value, float most, const char* what)
    {
        for (int k = 0; k < value.length(); ++k) keep_within(value[k], 0.0f, most, what);
    }

    void read_core()
    {
        Material& m = material_;
        if (const std::optional<Place> pbr = place_.find("pbrMetallicRoughness")) {
            m.base_color = vec4(*pbr, "baseColorFactor", m.base_color);
            m.base_color_texture = texture(*pbr, "baseColorTexture");
            m.metallic = pbr->number("metallicFactor", m.metallic);
            m.roughness = pbr->number("roughnessFactor", m.roughness);
            m.metallic_roughness_texture = texture(*pbr, "metallicRoughnessTexture");
        }
        m.normal_texture = texture(place_, "normalTexture");
        m.normal_scale = in_texture(place_, "normalTexture", "scale");
        m.occlusion_texture = texture(place_, "occlusionTexture");
        m.occlusion_strength = in_texture(place_, "occlusionTexture", "strength");
        m.emissive = vec3(place_, "emissiveFactor", m.emissive);
        m.emissive_texture = texture(place_, "emissiveTexture");
        m.alpha_cutoff = place_.number("alphaCutoff", m.alpha_cutoff);
        m.double_sided = place_.boolean("doubleSided", false);
        const std::string mode = place_.text("alphaMode");
        if (mode == "MASK")
            m.alpha_mode = AlphaMode::kMask;
        else if (mode == "BLEND")
            m.alpha_mode = AlphaMode::kBlend;
        else if (mode != "OPAQUE" && !mode.empty())
            loader_.warn(
                "alpha mode", fmt::format("{}.alphaMode '{}' is none of OPAQUE, MASK, BLEND; "
                                          "OPAQUE is used",
                                  place_.path(), mode));
        keep_all_within(m.base_color, 1.0f, "baseColorFactor");
        keep_within(m.metallic, 0.0f, 1.0f, "metallicFactor");
        keep_within(m.roughness, 0.0f, 1.0f, "roughnessFactor");
        keep_within(m.occlusion_strength, 0.0f, 1.0f, "occlusionTexture.strength");
        // Exporters wrote more than 1 before KHR_materials_emissive_strength, and it is meant.
        keep_all_within(m.emissive, kLarge, "emissiveFactor");
        keep_within(m.alpha_cutoff, 0.0f, kLarge, "alphaCutoff");
    }

    void read_extensions()
    {
        Material& m = material_;
        m.unlit = place_.extension("KHR_materials_unlit").has_value();
        if (const auto e = place_.extension("KHR_materials_emissive_strength")) {
            m.emissive_strength = e->number("emissiveStrength", m.emissive_strength);
            keep_within(m.emissive_strength, 0.0f, kLarge, "emissiveStrength");
        }
        if (const auto e = place_.extension("KHR_materials_ior")) {
            m.ior = e->number("ior", 1.5f);
            if (*m.ior != 0.0f) keep_within(*m.ior, 1.0f, kLarge, "ior");
        }
        read_specular();
        read_specular_glossiness();
        read_transmission();
        read_coats();
    }

    void read_specular()
    {
        const auto e = place_.extension("KHR_materials_specular");
        if (!e) return;
        Specular& s = material_.specular.emplace();
        s.factor = e->number("specularFactor", s.factor);
        s.texture = texture(*e, "specularTexture");
        s.color = vec3(*e, "specularColorFactor", s.color);
        s.color_texture = texture(*e, "specularColorTexture");
        keep_within(s.factor, 0.0f, 1.0f, "specularFactor");
        keep_all_within(s.color, kLarge, "specularColorFactor");
    }

    void read_specular_glossiness()
    {
        const auto e = place_.extension("KHR_materials_pbrSpecularGlossiness");
        if (!e) return;
        SpecularGlossiness& s = material_.specular_glossiness.emplace();
        s.diffuse = vec4(*e, "diffuseFactor", s.diffuse);
        s.diffuse_texture = texture(*e, "diffuseTexture");
        s.specular = vec3(*e, "specularFactor", s.specular);
        s.glossiness = e->number("glossinessFactor", s.glossiness);
        s.specular_glossiness_texture = texture(*e, "specularGlossinessTexture");
        keep_all_within(s.diffuse, 1.0f, "diffuseFactor");
        keep_all_within(s.specular, 1.0f, "specularFactor");
        keep_within(s.glossiness, 0.0f, 1.0f, "glossinessFactor");
    }

    void read_transmission()
    {
        if (const auto e = place_.extension("KHR_materials_transmission")) {
            Transmission& t = material_.transmission.emplace();
            t.factor = e->number("transmissionFactor", t.factor);
            t.texture = texture(*e, "transmissionTexture");
            keep_within(t.factor, 0.0f, 1.0f, "transmissionFactor");
        }
        if (const auto e = place_.extension("KHR_materials_volume")) {
            Volume& v = material_.volume.emplace();
            v.thickness = e->number("thicknessFactor", v.thickness);
            v.thickness_texture = texture(*e, "thicknessTexture");
            v.attenuation_distance = e->number("attenuationDistance", v.attenuation_distance);
            v.attenuation_color = vec3(*e, "attenuationColor", v.attenuation_color);
            keep_within(v.thickness, 0.0f, kLarge, "thicknessFactor");
            keep_within(v.attenuation_distance, 0.0f, kLarge, "attenuationDistance");
            keep_all_within(v.attenuation_color, 1.0f, "attenuationColor");
        }
    }

    void read_coats()
    {
        if (const auto e = place_.extension("KHR_materials_clearcoat")) {
            Clearcoat& c = material_.clearcoat.emplace();
            c.factor = e->number("clearcoatFactor", c.factor);
            c.texture = texture(*e, "clearcoatTexture");
            c.roughness = e->number("clearcoatRoughnessFactor", c.roughness);
            c.roughness_texture = texture(*e, "clearcoatRoughnessTexture");
            c.normal_texture = texture(*e, "clearcoatNormalTexture");
            c.normal_scale = in_texture(*e, "clearcoatNormalTexture", "scale");
            keep_within(c.factor, 0.0f, 1.0f, "clearcoatFactor");
            keep_within(c.roughness, 0.0f, 1.0f, "clearcoatRoughnessFactor");
        }
        if (const auto e = place_.extension("KHR_materials_sheen")) {
            Sheen& s = material_.sheen.emplace();
            s.color = vec3(*e, "sheenColorFactor", s.color);
            s.color_texture = texture(*e, "sheenColorTexture");
            s.roughness = e->number("sheenRoughnessFactor", s.roughness);
            s.roughness_texture = texture(*e, "sheenRoughnessTexture");
            keep_all_within(s.color, 1.0f, "sheenColorFactor");
            keep_within(s.roughness, 0.0f, 1.0f, "sheenRoughnessFactor");
        }
    }

    static constexpr std::size_t kMaxTexCoord = 1 << 16; // more are no real file's
    static constexpr float kLarge = 1e30f;
    Loader& loader_;
    const Place& place_;
    Material material_;
};

} // namespace

void read_materials(Loader& loader)
{
    loader.root.each("materials", [&](std::size_t, const Place& place) {
        loader.document.materials.push_back(MaterialReader(loader, place).read());
    });
}

} // namespace firsthit::gltf
