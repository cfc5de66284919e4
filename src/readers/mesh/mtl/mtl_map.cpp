// mtl_map.cpp - a texture as a material library names it, with its options.
//
// source  Wavefront 1995, "MTL material format"
#include "readers/mesh/mtl/mtl_map.h"

#include "io/parse_number.h"
#include "readers/mesh/obj/obj_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace firsthit {
namespace {

/// How many words belong to an option: numbers, at most that many, or any one word.
struct Option {
    std::string_view name;
    std::size_t numbers;
    bool is_word;
};
constexpr auto kOptions = std::to_array<Option>({{"-s", 3, false}, {"-o", 3, false},
    {"-t", 3, false}, {"-mm", 2, false}, {"-bm", 1, false}, {"-boost", 1, false},
    {"-texres", 1, false}, {"-blendu", 1, true}, {"-blendv", 1, true}, {"-cc", 1, true},
    {"-clamp", 1, true}, {"-imfchan", 1, true}, {"-type", 1, true}, {"-colorspace", 1, true}});

bool is_option(std::string_view word)
{
    return word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1]));
}

class MapReader {
  public:
    explicit MapReader(std::string_view text) : text_(without_blanks(text))
    {
        std::string_view rest = text_;
        for (std::string_view w = take_obj_word(rest); !w.empty(); w = take_obj_word(rest))
            words_.push_back(w);
    }

    MtlMap run()
    {
        while (at_ < words_.size()) {
            if (is_option(words_[at_]))
                read_option(words_[at_++]);
            else
                take_name(words_[at_++]);
        }
        if (first_ != nullptr) map_.file = std::string(first_, last_);
        if (map_.file.size() > 1 && map_.file.front() == '"' && map_.file.back() == '"')
            map_.file = map_.file.substr(1, map_.file.size() - 2);
        std::replace(map_.file.begin(), map_.file.end(), '\\', '/');
        return std::move(map_);
    }

  private:
    void take_name(std::string_view word)
    {
        if (first_ == nullptr) first_ = word.data();
        last_ = word.data() + word.size();
    }

    /// The last word may look like a value and still be the file's name, if there is none before.
    bool has_value() const
    {
        return at_ < words_.size() && (first_ != nullptr || at_ + 1 < words_.size());
    }

    void read_option(std::string_view name)
    {
        const auto* const option = std::find_if(
            kOptions.begin(), kOptions.end(), [&](const Option& o) { return o.name == name; });
        const bool known = option != kOptions.end();
        if (known && option->is_word) {
            if (has_value()) set_word(name, words_[at_++]);
            return;
        }
        // What belongs to an unknown option is guessed.
        std::array<float, 3> value{};
        std::size_t count = 0;
        for (; has_value() && count < (known ? option->numbers : 3); ++count, ++at_) {
            const std::string_view word = words_[at_];
            const std::optional<float> number = parse_float(word);
            if (!number && (known || (word != "on" && word != "off"))) break;
            value[count] = number.value_or(0.0f);
        }
        if (known) set_numbers(name, {value.data(), count});
    }

    void set_word(std::string_view name, std::string_view value)
    {
        if (name == "-clamp") map_.clamp = value == "on";
        if (name == "-imfchan") map_.channel = value[0];
    }

    void set_numbers(std::string_view name, std::span<const float> value)
    {
        const bool finite =
            std::all_of(value.begin(), value.end(), [](float v) { return std::isfinite(v); });
        if (value.empty() || !finite) {
            map_.bad_number = true;
            return;
        }
        if (name == "-s") map_.scale = {value[0], value.size() > 1 ? value[1] : value[0]};
        if (name == "-o") map_.offset = {value[0], value.size() > 1 ? value[1] : 0.0f};
        if (name == "-bm") map_.strength = value[0];
    }

    std::string_view text_;
    std::vector<std::string_view> words_;
    std::size_t at_ = 0;
    const char* first_ = nullptr; // of the name, in text_
    const char* last_ = nullptr;
    MtlMap map_;
};

} // namespace

MtlMap read_mtl_map(std::string_view text)
{
    return MapReader(text).run();
}

} // namespace firsthit
