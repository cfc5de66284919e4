// file_pattern.cpp - names of numbered files.
#include <firsthit/file_pattern.h>

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace firsthit {
namespace {

namespace fs = std::filesystem;

/// The number that a text has after leading spaces; nothing where it is none or too large.
std::optional<int> number_in(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    constexpr std::size_t kMostDigits = 9; // more could not be held by an int
    const std::size_t zeros = std::min(text.find_first_not_of('0'), text.size());
    if (text.empty() || text.size() - zeros > kMostDigits) return std::nullopt;
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || rest != end || number < 0) return std::nullopt;
    return number;
}

} // namespace

FilePattern::FilePattern(std::string text) : text_(std::move(text))
{
    const auto refuse = [&](const char* reason) {
        throw ArgumentError(
            fmt::format("'{}' {}: the names of numbered files need exactly one place for their "
                        "number, as in frames_%04d",
                text_, reason));
    };
    bool found = false;
    for (std::size_t k = 0; k < text_.size(); ++k) {
        std::string& part = found ? after_ : before_;
        if (text_[k] != '%') {
            part += text_[k];
            continue;
        }
        ++k;
        if (k < text_.size() && text_[k] == '%') {
            part += '%';
            continue;
        }
        if (found) refuse("has more than one %");
        if (k < text_.size() && text_[k] == '0') {
            fill_ = '0';
            ++k;
        }
        if (k < text_.size() && '1' <= text_[k] && text_[k] <= '9') {
            width_ = static_cast<std::size_t>(text_[k] - '0');
            ++k;
        }
        if (k >= text_.size() || text_[k] != 'd') refuse("has a % that is not %d, %4d or %04d");
        found = true;
    }
    if (!found) refuse("has no %d");
}

std::string FilePattern::name(int number) const
{
    const std::string digits = std::to_string(number);
    const std::size_t missing = width_ > digits.size() ? width_ - digits.size() : 0;
    return before_ + std::string(missing, fill_) + digits + after_;
}

std::vector<int> FilePattern::existing() const
{
    // The number may be in the name of a folder: names of that folder's own folder are compared.
    const std::size_t slash = before_.rfind('/') + 1; // 0 where there is none
    const std::string folder = slash > 0 ? before_.substr(0, slash) : ".";
    const std::string prefix = before_.substr(slash);
    const std::string suffix = after_.substr(0, after_.find('/'));

    std::vector<int> numbers;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.size() < prefix.size() + suffix.size() || !name.starts_with(prefix) ||
            !name.ends_with(suffix))
            continue;
        const std::optional<int> number = number_in(std::string_view(name).substr(
            prefix.size(), name.size() - prefix.size() - suffix.size()));
        if (!number) continue;
        const std::string path = this->name(*number);
        std::error_code unreadable;
        if (path.compare(slash, name.size(), name) == 0 && fs::is_regular_file(path, unreadable))
            numbers.push_back(*number);
    }
    if (error)
        throw FileError(fmt::format(
            "{}: the folder '{}' cannot be listed: {}", text_, folder, error.message()));
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

} // namespace firsthit
