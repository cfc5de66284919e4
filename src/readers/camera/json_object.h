// json_object.h - a JSON object that knows where it is in its file: numbers in double precision, or an error with
// the place.
#pragma once

#include "readers/gltf/document/json_text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

class JsonObject {
  public:
    /// place  as "cameras.json: frames[3]"
    /// throws  FileError: no object
    JsonObject(const gltf::Json& json, std::string place);

    bool has(const char* key) const { return json_->contains(key); }

    /// A finite number. throws  FileError: no such, also where it is missing
    double number(const char* key) const;
    double number(const char* key, double fallback) const;
    /// throws  FileError: no whole number from low to high
    int integer(const char* key, int low, int high) const;
    std::string text(const char* key, const std::string& fallback) const;
    /// So many finite numbers, also in nested arrays of one shape: a matrix row by row.
    /// throws  FileError: another shape
    std::vector<double> numbers(const char* key, std::size_t rows, std::size_t columns) const;
    /// Any number of finite numbers; empty where they are missing.
    std::vector<double> list(const char* key) const;
    /// The array under a key. throws  FileError: missing, no array, or empty
    const gltf::Json& array(const char* key) const;

    /// throws  FileError "place.key: message"
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;
    const std::string& place() const { return place_; }

  private:
    const gltf::Json& member(const char* key) const;

    const gltf::Json* json_;
    std::string place_;
};

} // namespace firsthit
