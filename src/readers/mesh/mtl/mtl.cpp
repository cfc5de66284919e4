// mtl.cpp - the material libraries of OBJ files.
//
// source  Wavefront 1995, "MTL material format"; Pr, Pm, norm: the extension for physically based shading
//         of Clara.io 2014, "Physically-Based Rendering extension for the MTL material format"
#include "readers/mesh/mtl/mtl.h"

#include "io/parse_number.h"
#include "io/text_cursor.h"
#include "readers/mesh/obj/obj_lines.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace firsthit {
namespace {

/// A guard: a material takes 100 times as much memory as the shortest text of one.
constexpr std::size_t kMostMaterials = std::size_t(1) << 18;

/// Pictures that our models lack a place for, and whose lack is seen.
constexpr auto kNotShown = std::to_array<std::string_view>({"bump", "map_bump", "disp", "map_disp",
    "decal", "refl", "map_refl", "map_ks", "map_ns", "map_ps", "map_rma", "map_orm"});

/// What other models have, and what says how to render. The ambient colour takes the picture of the diffuse one.
constexpr auto kMtlIgnored = std::to_array<std::string_view>(
    {"illum", "tf", "sharpness", "km", "map_ka", "map_aat", "ps", "pc", "pcr", "aniso", "anisor"});

/// Kinds of unknown statements that are told of by name.
constexpr std::size_t kMostUnknownWords = 8;

class MtlReader {
  public:
    MtlReader(std::string_view text, const std::string& name, Problems& problems)
        : lines_(text),
          name_(name),
          problems_(problems)
    {
    }

    std::vector<MtlMaterial> run()
    {
        while (lines_.next()) {
            std::string_view text = lines_.statement();
            const std::string_view first = take_obj_word(text);
            if (first.empty() || first[0] == '#') continue;
            std::string word(first);
            std::transform(word.begin(), word.end(), word.begin(),
                [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            text_ = text;
            read_statement(word);
        }
        finish();
        return std::move(materials_);
    }

  private:
    void read_statement(const std::string& word)
    {
        if (word == "newmtl") {
            finish();
            if (materials_.size() == kMostMaterials)
                throw FileError(fmt::format(
                    "{}:{}: more than {} materials", name_, lines_.line(), kMostMaterials));
            materials_.emplace_back().name = without_blanks(text_);
            has_ambient_ = false;
            transparency_.reset();
            opacity_.reset();
            return;
        }
        if (materials_.empty()) {
            add_problem("statements before the first newmtl are left out");
            return;
        }
        if (!read_color(word) && !read_value(word)) read_map(word);
    }

    bool read_color(const std::string& word)
    {
        MtlMaterial& made = materials_.back();
        glm::vec3* const color = word == "ka"   ? &made.phong.ambient
                                 : word == "kd" ? &made.phong.diffuse
                                 : word == "ks" ? &made.phong.specular
                                 : word == "ke" ? &made.emission
                                                : nullptr;
        if (color == nullptr) return false;
        // Spectral curves and CIE xyz are kept out.
        std::string_view ahead = text_;
        const std::string_view first = take_obj_word(ahead);
        if (first == "spectral" || first == "xyz") return true;
        std::array<std::optional<float>, 3> value;
        for (std::size_t k = 0; k < 3 && (k == 0 || has_number()); ++k) {
            value[k] = take_number();
            if (!value[k]) return true;
        }
        *color = {*value[0], value[1].value_or(*value[0]), value[2].value_or(*value[0])};
        if (word == "ka") has_ambient_ = true;
        return true;
    }

    bool read_value(const std::string& word)
    {
        MtlMaterial& made = materials_.back();
        // "-halo" is a fall-off towards the rim, which our models lack.
        std::string_view ahead = text_;
        if (word == "d" && take_obj_word(ahead) == "-halo") text_ = ahead;
        if (word == "ns")
            made.phong.shininess = std::max(0.0f, take_number().value_or(made.phong.shininess));
        else if (word == "ni")
            made.phong.ior = take_number().value_or(made.phong.ior);
        else if (word == "d")
            opacity_ = take_share();
        else if (word == "tr")
            read_transparency();
        else if (word == "pr")
            made.roughness = take_share();
        else if (word == "pm")
            made.metallic = take_share();
        else
            return false;
        return true;
    }

    void read_transparency()
    {
        transparency_ = take_share();
        if (transparency_ == 1.0f && !opacity_)
            add_problem("Tr 1 without a d in front is taken for opaque, as some programs mean it");
    }

    void read_map(const std::string& word)
    {
        MtlMaterial& made = materials_.back();
        const auto maps =
            std::to_array<std::pair<std::string_view, MtlMap*>>({{"map_kd", &made.diffuse_map},
                {"map_d", &made.opacity_map}, {"map_ke", &made.emission_map},
                {"map_pr", &made.roughness_map}, {"map_pm", &made.metallic_map},
                {"norm", &made.normal_map}, {"map_norm", &made.normal_map}});
        for (const auto& [name, map] : maps) {
            if (word != name) continue;
            *map = read_mtl_map(text_);
            if (map->bad_number)
                add_problem("options whose numbers are missing or not finite are left out");
            return;
        }
        if (std::find(kNotShown.begin(), kNotShown.end(), word) != kNotShown.end())
            add_problem(fmt::format("pictures of '{}' are not shown", word));
        else if (std::find(kMtlIgnored.begin(), kMtlIgnored.end(), word) == kMtlIgnored.end())
            add_unknown(word);
    }

    void add_unknown(const std::string& word)
    {
        if (unknown_.size() < kMostUnknownWords) unknown_.emplace(word);
        if (unknown_.count(word) > 0)
            add_problem(fmt::format("unknown statements '{}' are left out", printable(word)));
        else
            add_problem("other unknown statements are left out");
    }

    /// What is known when all of a material's statements have been read.
    void finish()
    {
        if (materials_.empty()) return;
        MtlMaterial& made = materials_.back();
        if (!has_ambient_) made.phong.ambient = made.phong.diffuse;
        const float transparency = transparency_.value_or(0.0f);
        made.opacity = opacity_.value_or(transparency < 1 ? 1 - transparency : 1.0f);
        made.phong.transmittance = 1 - made.opacity;
    }

    bool has_number() const
    {
        std::string_view ahead = text_;
        const std::string_view word = take_obj_word(ahead);
        return !word.empty() && word[0] != '#';
    }

    std::optional<float> take_number()
    {
        std::string word(take_obj_word(text_));
        if (const std::size_t comma = word.find(','); comma != word.npos) {
            add_problem("commas in numbers are decimal points or blanks");
            if (comma + 1 == word.size())
                word.pop_back();
            else
                word[comma] = '.';
        }
        const std::optional<float> number = parse_float(word);
        if (number && std::isfinite(*number)) return number;
        add_problem("values that are no finite number are left out");
        return {};
    }

    /// From 0 to 1.
    std::optional<float> take_share()
    {
        const std::optional<float> number = take_number();
        if (!number) return {};
        return std::clamp(*number, 0.0f, 1.0f);
    }

    void add_problem(std::string_view kind) { problems_.add(kind, "line", lines_.line()); }

    ObjLines lines_;
    const std::string& name_;
    Problems& problems_;
    std::string_view text_; // of the statement, behind what has been read
    std::vector<MtlMaterial> materials_;
    bool has_ambient_ = false; // the last material
    std::optional<float> opacity_, transparency_;
    std::set<std::string> unknown_; // statements
};

} // namespace

std::vector<MtlMaterial> read_mtl(
    std::string_view text, const std::string& name, Problems& problems)
{
    return MtlReader(obj_text(text, name), name, problems).run();
}

} // namespace firsthit
