// place.cpp - typed members of JSON objects, with errors that name the place.
#include "readers/gltf/document/place.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>

namespace firsthit::gltf {
namespace {

std::string joined(std::string path, std::string_view key)
{
    if (!path.empty() && !key.empty()) path += '.';
    return path.append(key);
}

} // namespace

std::string shown(std::string_view message)
{
    constexpr std::size_t kMost = 1000; // bytes; names in a file may be of any length
    std::string text(message.substr(0, kMost));
    if (message.size() > kMost) text += "...";
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
    return text;
}

Place::Place(const std::string& file, const Json& json) : file_(&file), json_(&json) {}

Place::Place(const Place& parent, std::string_view key, std::size_t number, const Json& json)
    : file_(parent.file_),
      json_(&json),
      parent_(&parent),
      key_(key),
      number_(number)
{
    if (!json.is_object())
        fail("", fmt::format("an object was expected, not {}", json.type_name()));
}

std::string Place::path() const
{
    if (!parent_) return {};
    std::string path = joined(parent_->path(), key_);
    if (number_ != kNoNumber) path += fmt::format("[{}]", number_);
    return path;
}

void Place::fail(std::string_view key, std::string_view message) const
{
    const std::string place = joined(path(), key);
    throw FileError(
        fmt::format("{}: {}{}{}", *file_, shown(place), place.empty() ? "" : ": ", shown(message)));
}

const Json* Place::member(const char* key) const
{
    const auto found = json_->find(key);
    return found == json_->end() ? nullptr : &*found;
}

const Json* Place::array(const char* key) const
{
    const Json* const json = member(key);
    if (json && !json->is_array())
        fail(key, fmt::format("an array was expected, not {}", json->type_name()));
    return json;
}

std::optional<Place> Place::find(const char* key) const
{
    const Json* const json = member(key);
    if (!json) return std::nullopt;
    return Place(*this, key, kNoNumber, *json);
}

std::optional<Place> Place::extension(const char* name) const
{
    const Json* const all = member("extensions");
    if (!all) return std::nullopt;
    if (!all->is_object())
        fail("extensions", fmt::format("an object was expected, not {}", all->type_name()));
    const auto found = all->find(name);
    if (found == all->end()) return std::nullopt;
    // The parent is the object itself: "materials[3].KHR_materials_ior.ior" says enough.
    return Place(*this, name, kNoNumber, *found);
}

std::string Place::text(const char* key) const
{
    const Json* const json = member(key);
    if (!json) return {};
    if (!json->is_string())
        fail(key, fmt::format("a text was expected, not {}", json->type_name()));
    return json->get<std::string>();
}

bool Place::boolean(const char* key, bool fallback) const
{
    const Json* const json = member(key);
    if (!json) return fallback;
    if (!json->is_boolean())
        fail(key, fmt::format("true or false was expected, not {}", json->type_name()));
    return json->get<bool>();
}

float Place::finite(std::string_view key, const Json& json) const
{
    if (!json.is_number())
        fail(key, fmt::format("a number was expected, not {}", json.type_name()));
    const float value = static_cast<float>(json.get<double>());
    if (!std::isfinite(value)) fail(key, "the number is too large for a float");
    return value;
}

float Place::number(const char* key, float fallback) const
{
    const Json* const json = member(key);
    return json ? finite(key, *json) : fallback;
}

float Place::number(const char* key) const
{
    const Json* const json = member(key);
    if (!json) fail(key, "is missing");
    return finite(key, *json);
}

std::size_t Place::whole(std::string_view key, const Json& json, std::size_t most) const
{
    if (!json.is_number())
        fail(key, fmt::format("a whole number was expected, not {}", json.type_name()));
    // Some writers make 3.0 of 3.
    const double value = json.get<double>();
    if (!(value >= 0.0 && value <= double(most)) || value != std::floor(value))
        fail(key, fmt::format("{} is not accepted, a whole number from 0 to {} is", value, most));
    return static_cast<std::size_t>(value);
}

std::size_t Place::size(const char* key, std::size_t fallback, std::size_t most) const
{
    const Json* const json = member(key);
    return json ? whole(key, *json, most) : fallback;
}

std::size_t Place::size(const char* key) const
{
    const Json* const json = member(key);
    if (!json) fail(key, "is missing");
    return whole(key, *json, kMost);
}

int Place::below(std::string_view key, const Json& json, std::size_t count) const
{
    if (!json.is_number())
        fail(key, fmt::format("a whole number was expected, not {}", json.type_name()));
    const double value = json.get<double>();
    if (!(value >= 0.0 && value < double(count)) || value != std::floor(value))
        fail(key, fmt::format("{} is out of range, there are {}", value, count));
    return static_cast<int>(value);
}

int Place::index(const char* key, std::size_t count) const
{
    const Json* const json = member(key);
    return json ? below(key, *json, count) : kNone;
}

int Place::required_index(const char* key, std::size_t count) const
{
    const Json* const json = member(key);
    if (!json) fail(key, "is missing");
    return below(key, *json, count);
}

std::vector<int> Place::indices(const char* key, std::size_t count) const
{
    std::vector<int> values;
    const Json* const json = array(key);
    if (!json) return values;
    values.reserve(json->size());
    for (const Json& value : *json) values.push_back(below(key, value, count));
    return values;
}

std::vector<float> Place::numbers(const char* key) const
{
    std::vector<float> values;
    const Json* const json = array(key);
    if (!json) return values;
    values.reserve(json->size());
    for (const Json& value : *json) values.push_back(finite(key, value));
    return values;
}

void Place::exact_numbers(const char* key, float* values, std::size_t count) const
{
    const Json* const json = array(key);
    if (json->size() != count)
        fail(key, fmt::format("{} numbers instead of {}", json->size(), count));
    for (std::size_t k = 0; k < count; ++k) values[k] = finite(key, (*json)[k]);
}

void Place::each_index(
    std::size_t count, const std::function<void(const std::string&, int)>& visit) const
{
    for (const auto& [key, value] : json_->items()) visit(key, below(key, value, count));
}

void Place::each(const char* key, const std::function<void(std::size_t, const Place&)>& visit) const
{
    const Json* const json = array(key);
    if (!json) return;
    for (std::size_t k = 0; k < json->size(); ++k) visit(k, Place(*this, key, k, (*json)[k]));
}

std::size_t Place::length(const char* key) const
{
    const Json* const json = array(key);
    return json ? json->size() : 0;
}

} // namespace firsthit::gltf
