// place.h - a JSON object of a glTF file that knows where it is: typed members, or an error with the place.
#pragma once

#include "readers/gltf/data/accessor.h"
#include "readers/gltf/document/json_text.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::gltf {

/// A message that may hold texts of a file: without control characters, not too long.
std::string shown(std::string_view message);

/// Members that are missing have the fallback, or are an error where there is none. Must not outlive the
/// JSON or the place it was got from.
class Place {
  public:
    /// file  stands in the messages
    /// json  an object
    Place(const std::string& file, const Json& json);

    bool has(const char* key) const { return json_->contains(key); }
    const Json& json() const { return *json_; }

    /// An object; nothing where it is missing.
    std::optional<Place> find(const char* key) const;
    /// The object extensions.NAME; nothing where either is missing.
    std::optional<Place> extension(const char* name) const;

    std::string text(const char* key) const; // empty where it is missing
    bool boolean(const char* key, bool fallback) const;
    float number(const char* key, float fallback) const;
    float number(const char* key) const;
    /// A whole number from 0 to `most`.
    std::size_t size(const char* key, std::size_t fallback, std::size_t most = kMost) const;
    std::size_t size(const char* key) const;
    /// A number below `count`, kNone where it is missing.
    int index(const char* key, std::size_t count) const;
    int required_index(const char* key, std::size_t count) const;
    /// Numbers below `count`, empty where they are missing.
    std::vector<int> indices(const char* key, std::size_t count) const;
    /// Any number of finite numbers, empty where they are missing.
    std::vector<float> numbers(const char* key) const;
    /// As many numbers; false where they are missing.
    template <std::size_t N>
    bool numbers(const char* key, std::array<float, N>& values) const
    {
        if (!has(key)) return false;
        exact_numbers(key, values.data(), N);
        return true;
    }
    /// Each member of the object as a number below `count`.
    void each_index(
        std::size_t count, const std::function<void(const std::string&, int)>& visit) const;
    /// Each object of an array, with its number; the array may be missing.
    void each(const char* key, const std::function<void(std::size_t, const Place&)>& visit) const;
    /// Of an array; 0 where it is missing.
    std::size_t length(const char* key) const;

    /// throws  FileError "file: materials[3].name: message"; key may be empty
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;
    /// As "materials[3]"; empty at the top.
    std::string path() const;
    const std::string& file() const { return *file_; }

    static constexpr std::size_t kMost = std::size_t(1) << 53; // that a JSON number holds exactly

  private:
    Place(const Place& parent, std::string_view key, std::size_t number, const Json& json);
    const Json* member(const char* key) const;
    const Json* array(const char* key) const;
    std::size_t whole(std::string_view key, const Json& json, std::size_t most) const;
    int below(std::string_view key, const Json& json, std::size_t count) const;
    float finite(std::string_view key, const Json& json) const;
    void exact_numbers(const char* key, float* values, std::size_t count) const;

    static constexpr std::size_t kNoNumber = ~std::size_t(0);
    const std::string* file_;
    const Json* json_;
    const Place* parent_ = nullptr;
    std::string_view key_;           // in the parent
    std::size_t number_ = kNoNumber; // in the parent's array
};

} // namespace firsthit::gltf
