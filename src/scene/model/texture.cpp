// texture.cpp - pictures to texels that shading can sample.
#include "base/srgb.h"
#include "scene/model/mip_levels.h"

#include <firsthit/error.h>
#include <firsthit/texture.h>

#include <fmt/format.h>

#include <cmath>

namespace firsthit {
namespace {

constexpr float kOne = -32768.0f; // what stands for 1 in a texel

std::int16_t stored(float value)
{
    return static_cast<std::int16_t>(std::lround(std::min(std::max(value, 0.0f), 1.0f) * kOne));
}

/// What is stored for each of 256 codes.
using CodeTable = std::array<std::int16_t, 256>;

CodeTable stored_light()
{
    CodeTable table;
    for (std::size_t code = 0; code < table.size(); ++code)
        table[code] = stored(linear_from_srgb()[code]);
    return table;
}

CodeTable stored_share()
{
    CodeTable table;
    for (std::size_t code = 0; code < table.size(); ++code)
        table[code] = stored(static_cast<float>(code) / 255.0f);
    return table;
}

Texel texel_of(std::uint32_t rgba, Encoding encoding)
{
    static const CodeTable light = stored_light(), share = stored_share();
    const CodeTable& color = encoding == Encoding::srgb ? light : share;
    return {color[rgba & 255], color[rgba >> 8 & 255], color[rgba >> 16 & 255], share[rgba >> 24]};
}

Texel texel_of(const glm::vec4& linear, Encoding)
{
    return {stored(linear.r), stored(linear.g), stored(linear.b), stored(linear.a)};
}

/// Appends a picture of any pixels with its border, where it begins anew.
template <class AnyPicture>
void append_level(const AnyPicture& picture, Encoding encoding, std::vector<Texel>& texels)
{
    const auto width = std::size_t(picture.width), height = std::size_t(picture.height);
    for (std::size_t y = 0; y < height + 2; ++y) {
        const auto* row = picture.pixel.data() + (y + height - 1) % height * width;
        texels.push_back(texel_of(row[width - 1], encoding));
        for (std::size_t x = 0; x < width; ++x) texels.push_back(texel_of(row[x], encoding));
        texels.push_back(texel_of(row[0], encoding));
    }
}

void check(const std::string& name, std::span<const Picture> levels)
{
    if (levels.empty()) throw ArgumentError(fmt::format("texture '{}': there is no picture", name));
    int width = levels[0].width, height = levels[0].height;
    if (width < 1 || height < 1 || width > Texture::kMaxSide || height > Texture::kMaxSide ||
        std::int64_t(width) * height > Texture::kMaxTexels)
        throw ArgumentError(fmt::format(
            "texture '{}': {} x {} texels, 1 to {} on a side and at most {} are accepted", name,
            width, height, Texture::kMaxSide, Texture::kMaxTexels));
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const Picture& level = levels[l];
        if (level.width != width || level.height != height)
            throw ArgumentError(fmt::format("texture '{}': level {} is {} x {} instead of {} x {}",
                name, l, level.width, level.height, width, height));
        if (level.pixel.size() != std::size_t(width) * std::size_t(height))
            throw ArgumentError(fmt::format("texture '{}': level {} has {} pixels for {} x {}",
                name, l, level.pixel.size(), width, height));
        if (width == 1 && height == 1 && l + 1 < levels.size())
            throw ArgumentError(fmt::format("texture '{}': {} levels, of which level {} is the "
                                            "last that can be",
                name, levels.size(), l));
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
    }
}

} // namespace

Texture::Texture(std::string name, std::span<const Picture> levels, Encoding encoding)
    : name_(std::move(name))
{
    check(name_, levels);
    width_ = levels[0].width;
    height_ = levels[0].height;
    levels_ = static_cast<int>(levels.size());
    if (levels_ == 1)
        while (width(levels_ - 1) > 1 || height(levels_ - 1) > 1) ++levels_;
    std::size_t texels = 0;
    for (int l = 0; l < levels_; ++l) {
        first_[std::size_t(l)] = static_cast<std::int32_t>(texels);
        texels += std::size_t(width(l) + 2) * std::size_t(height(l) + 2);
    }
    texel_.reserve(texels);

    for (const Picture& level : levels) append_level(level, encoding, texel_);
    if (levels.size() > 1 || levels_ == 1) return;
    // From the stored picture only once: later levels come from unrounded light.
    LinearPicture linear = half_of(levels[0], encoding);
    append_level(linear, encoding, texel_);
    for (int l = 2; l < levels_; ++l) {
        linear = half_of(linear);
        append_level(linear, encoding, texel_);
    }
}

glm::vec4 Texture::color(int level, int column, int row) const
{
    const Texel& texel =
        texel_[std::size_t(first_[std::size_t(level)]) +
               std::size_t(row + 1) * std::size_t(width(level) + 2) + std::size_t(column + 1)];
    const auto channel = [&](std::size_t c) { return static_cast<float>(texel[c]) / kOne; };
    return {channel(0), channel(1), channel(2), channel(3)};
}

void Texture::set_sampler(const Sampler& sampler)
{
    const bool same = sampler.wrap_u == sampler_.wrap_u && sampler.wrap_v == sampler_.wrap_v;
    sampler_ = sampler;
    if (!same) fill_borders();
}

void Texture::fill_borders()
{
    const bool repeat_u = sampler_.wrap_u == Wrap::repeat;
    const bool repeat_v = sampler_.wrap_v == Wrap::repeat;
    for (int l = 0; l < levels(); ++l) {
        const std::ptrdiff_t w = width(l), h = height(l), row = w + 2;
        const auto level = texel_.begin() + first_[std::size_t(l)];
        for (std::ptrdiff_t y = 1; y <= h; ++y) {
            const auto texel = level + y * row;
            texel[0] = texel[repeat_u ? w : 1];
            texel[w + 1] = texel[repeat_u ? 1 : w];
        }
        // Whole rows, with their ends.
        std::copy_n(level + (repeat_v ? h : 1) * row, row, level);
        std::copy_n(level + (repeat_v ? 1 : h) * row, row, level + (h + 1) * row);
    }
}

void Texture::turn_upside_down()
{
    for (int l = 0; l < levels(); ++l) {
        const std::ptrdiff_t row = width(l) + 2;
        auto top = texel_.begin() + first_[std::size_t(l)];
        for (auto bottom = top + row * (height(l) + 1); top < bottom; top += row, bottom -= row)
            std::swap_ranges(top, top + row, bottom);
    }
}

} // namespace firsthit
