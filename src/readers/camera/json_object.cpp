// json_object.cpp - a JSON object that knows where it is in its file.
#include "readers/camera/json_object.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace firsthit {
namespace {

/// The value where it is a finite number.
std::optional<double> finite_number(const gltf::Json& json)
{
    if (!json.is_number()) return {};
    const double value = json.get<double>();
    if (!std::isfinite(value)) return {};
    return value;
}

} // namespace

JsonObject::JsonObject(const gltf::Json& json, std::string place)
    : json_(&json),
      place_(std::move(place))
{
    if (!json.is_object()) throw FileError(fmt::format("{}: no object {{...}}", place_));
}

const gltf::Json& JsonObject::member(const char* key) const
{
    const auto found = json_->find(key);
    if (found == json_->end()) fail(key, "is missing");
    return *found;
}

double JsonObject::number(const char* key) const
{
    const std::optional<double> value = finite_number(member(key));
    if (!value) fail(key, "no finite number");
    return *value;
}

double JsonObject::number(const char* key, double fallback) const
{
    return has(key) ? number(key) : fallback;
}

int JsonObject::integer(const char* key, int low, int high) const
{
    const double value = number(key);
    if (!(low <= value && value <= high) || value != std::floor(value))
        fail(key, fmt::format("{:g} is no whole number from {} to {}", value, low, high));
    return static_cast<int>(value);
}

std::string JsonObject::text(const char* key, const std::string& fallback) const
{
    if (!has(key)) return fallback;
    const gltf::Json& json = member(key);
    if (!json.is_string()) fail(key, "no text");
    return json.get<std::string>();
}

std::vector<double> JsonObject::numbers(
    const char* key, std::size_t rows, std::size_t columns) const
{
    const gltf::Json& json = member(key);
    const std::string shape = rows == 1 ? fmt::format("{} numbers", columns)
                                        : fmt::format("{} rows of {} numbers", rows, columns);
    std::vector<double> values;
    const auto add = [&](const gltf::Json& row) {
        if (!row.is_array() || row.size() != columns) fail(key, "accepted are " + shape);
        for (const gltf::Json& value : row) {
            const std::optional<double> number = finite_number(value);
            if (!number) fail(key, "accepted are " + shape + ", all finite");
            values.push_back(*number);
        }
    };
    if (rows == 1) {
        add(json);
        return values;
    }
    if (!json.is_array() || json.size() != rows) fail(key, "accepted are " + shape);
    for (const gltf::Json& row : json) add(row);
    return values;
}

std::vector<double> JsonObject::list(const char* key) const
{
    std::vector<double> values;
    if (!has(key)) return values;
    const gltf::Json& json = member(key);
    if (!json.is_array()) fail(key, "no array of numbers");
    for (const gltf::Json& value : json) {
        const std::optional<double> number = finite_number(value);
        if (!number) fail(key, "an array of other than finite numbers");
        values.push_back(*number);
    }
    return values;
}

const gltf::Json& JsonObject::array(const char* key) const
{
    const gltf::Json& json = member(key);
    if (!json.is_array() || json.empty()) fail(key, "no array [...] with something in it");
    return json;
}

void JsonObject::fail(std::string_view key, std::string_view message) const
{
    throw FileError(fmt::format("{}: {}: {}", place_, key, message));
}

} // namespace firsthit
