// parse.cpp - turns words of the command line into values.
#include "common/parse.h"

#include "common/usage.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace firsthit::cli {

namespace {

constexpr int kMaxSide = 65536;       // of a View
constexpr int kMaxFrames = 1'000'000; // 11 hours of film

/// The whole text, without white space or a sign of plus.
template <class T>
std::optional<T> whole(std::string_view text)
{
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

std::optional<double> finite(std::string_view text)
{
    const std::optional<double> value = whole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t end = text.find(separator);
        words.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return words;
        text.remove_prefix(end + 1);
    }
}

} // namespace

double parse_number(const std::string& text)
{
    if (const auto value = finite(text)) return *value;
    throw UsageError(fmt::format("'{}' is no finite number", text));
}

int parse_integer(const std::string& text, int low, int high)
{
    const auto value = whole<int>(text);
    if (value && low <= *value && *value <= high) return *value;
    throw UsageError(fmt::format("'{}' is no integer from {} to {}", text, low, high));
}

Size parse_size(const std::string& text)
{
    const auto words = split(text, 'x');
    if (words.size() == 2) {
        const auto width = whole<int>(words[0]);
        const auto height = whole<int>(words[1]);
        const auto accepted = [](auto side) { return side && 1 <= *side && *side <= kMaxSide; };
        if (accepted(width) && accepted(height)) return {*width, *height};
    }
    throw UsageError(fmt::format(
        "'{}' is no size: accepted is WIDTHxHEIGHT, each 1 to {}, as 1024x768", text, kMaxSide));
}

glm::dvec3 parse_vector(const std::string& text)
{
    const auto words = split(text, ',');
    if (words.size() == 3) {
        const auto x = finite(words[0]), y = finite(words[1]), z = finite(words[2]);
        if (x && y && z) return {*x, *y, *z};
    }
    throw UsageError(
        fmt::format("'{}' is no vector: accepted are three numbers, as 0,1.5,-2", text));
}

std::vector<double> parse_frames(const std::string& text)
{
    const auto words = split(text, ':');
    if (words.size() == 3) {
        const auto first = finite(words[0]), last = finite(words[1]);
        const auto count = whole<int>(words[2]);
        if (first && last && count && 1 <= *count && *count <= kMaxFrames) {
            std::vector<double> times(static_cast<std::size_t>(*count), *first);
            for (int k = 1; k < *count; ++k) {
                const double part = static_cast<double>(k) / (*count - 1);
                times[static_cast<std::size_t>(k)] = *first * (1 - part) + *last * part;
            }
            return times;
        }
    }
    throw UsageError(
        fmt::format("'{}' is no range of frames: accepted is FIRST:LAST:COUNT, two times "
                    "in seconds and 1 to {} frames, as 0:10:25",
            text, kMaxFrames));
}

AovOutput parse_aov(const std::string& text)
{
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || sign + 1 == text.size())
        throw UsageError(
            fmt::format("'{}' is no plane: accepted is NAME=FILE, as item=item.npy", text));
    try {
        return {aov_from_name(text.substr(0, sign)), text.substr(sign + 1)};
    } catch (const ArgumentError& error) {
        throw UsageError(error.what());
    }
}

Multisample parse_multisample(const std::string& text)
{
    constexpr std::pair<std::string_view, Multisample> kModes[] = {{"none", Multisample::none},
        {"lazy3", Multisample::lazy3}, {"lazy5", Multisample::lazy5}, {"full3", Multisample::full3},
        {"full5", Multisample::full5}, {"exact", Multisample::exact}};
    for (const auto& [name, mode] : kModes)
        if (text == name) return mode;
    throw UsageError(
        fmt::format("'{}' is not accepted: none, lazy3, lazy5, full3, full5 or exact", text));
}

double parse_fov(const std::string& text)
{
    const auto degrees = finite(text);
    if (degrees && 0 < *degrees && *degrees < 180) return *degrees * (3.14159265358979323846 / 180);
    throw UsageError(fmt::format("'{}' is no angle above 0 and below 180 degrees", text));
}

} // namespace firsthit::cli
