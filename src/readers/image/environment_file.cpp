// environment_file.cpp - reads pictures of what is all around: Radiance by stb_image, OpenEXR.
#include "readers/image/environment_file.h"

#include "io/whole_file.h"

#include <firsthit/environment.h>
#include <firsthit/error.h>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <fmt/format.h>

#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

namespace firsthit {
namespace {

/// throws  FileError: empty, or larger than an environment may be
void check_size(const std::string& name, std::int64_t width, std::int64_t height)
{
    constexpr int kMaxSide = EnvironmentMap::kMaxSide;
    constexpr int kMaxPixels = 1 << 25; // 400 MB, which a small file can promise
    if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
        width * height > kMaxPixels)
        throw FileError(
            fmt::format("{}: a picture of {} x {} pixels: accepted are sides of 1 to {} and {} "
                        "pixels in all",
                name, width, height, kMaxSide, kMaxPixels));
}

/// Where the pixels of a Radiance picture begin: behind the line of its size, which follows the first
/// empty one. The end of the bytes where there is no such line.
std::size_t first_pixel(const std::string& bytes)
{
    const std::size_t empty = bytes.find("\n\n");
    if (empty == std::string::npos) return bytes.size();
    return std::min(bytes.find('\n', empty + 2), bytes.size() - 1) + 1;
}

/// Whether the pixels of a Radiance picture are all there and its runs fit into its lines. stb_image 2.27
/// loops for ever in a run of length 0, which it also reads behind the end.
///
/// source  Ward 1991, "Real Pixels", Graphics Gems II; Radiance's file format, "scanline records"
bool has_whole_lines(const std::string& bytes, std::size_t width, std::size_t height)
{
    std::size_t at = first_pixel(bytes);
    const auto left = [&] { return bytes.size() - at; };
    const auto next = [&] { return static_cast<unsigned char>(bytes[at++]); };
    const bool may_have_runs = 8 <= width && width < 32768;
    const auto begins_line_of_runs = [&] {
        return left() >= 4 && bytes[at] == 2 && bytes[at + 1] == 2 && !(bytes[at + 2] & 0x80);
    };
    if (!may_have_runs || !begins_line_of_runs()) return left() >= 4 * width * height;
    for (std::size_t line = 0; line < height; ++line) {
        if (!begins_line_of_runs()) return false;
        at += 4;
        for (int channel = 0; channel < 4; ++channel)
            for (std::size_t done = 0; done < width;) {
                if (left() < 2) return false;
                const std::size_t count = next();
                const bool is_run = count > 128;
                const std::size_t values = is_run ? count - 128 : count, given = is_run ? 1 : count;
                if (values == 0 || values > width - done || given > left()) return false;
                at += given;
                done += values;
            }
    }
    return true;
}

} // namespace

RadiancePicture decode_radiance(const std::string& name, const std::string& bytes)
{
    const auto fail = [&](const char* reason) {
        throw FileError(fmt::format("{}: not a Radiance picture, or a damaged one ({})", name,
            reason ? reason : "unknown"));
    };
    if (bytes.size() > std::size_t(std::numeric_limits<int>::max())) fail("too large");
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    if (!stbi_is_hdr_from_memory(data, size)) fail("it does not begin with #?RADIANCE or #?RGBE");
    RadiancePicture picture;
    int channels = 0;
    if (!stbi_info_from_memory(data, size, &picture.width, &picture.height, &channels))
        fail(stbi_failure_reason());
    check_size(name, picture.width, picture.height);
    // Runs of equal bytes are at most 127 long and take two bytes, and there are four values a pixel.
    const auto pixels = std::size_t(picture.width) * std::size_t(picture.height);
    if (bytes.size() < pixels / 16) fail("it is cut off");
    if (!has_whole_lines(bytes, std::size_t(picture.width), std::size_t(picture.height)))
        fail("it is cut off, or a run does not fit into its line");
    const std::unique_ptr<float, void (*)(void*)> rgb(
        stbi_loadf_from_memory(data, size, &picture.width, &picture.height, &channels, 3),
        stbi_image_free);
    if (!rgb) fail(stbi_failure_reason());
    picture.radiance.resize(pixels);
    std::memcpy(picture.radiance.data(), rgb.get(), pixels * sizeof(glm::vec3));
    return picture;
}

namespace {

/// A file in memory, for OpenEXR.
class MemoryStream : public Imf::IStream {
  public:
    MemoryStream(const std::string& name, const std::string& bytes)
        : Imf::IStream(name.c_str()),
          bytes_(bytes)
    {
    }

    bool read(char to[], int count) override
    {
        if (count < 0 || std::uint64_t(count) > bytes_.size() - at_)
            throw std::runtime_error("it is cut off");
        std::memcpy(to, bytes_.data() + at_, std::size_t(count));
        at_ += std::size_t(count);
        return at_ < bytes_.size();
    }
    // OpenEXR 2 and 3 have different integers here.
    using Position = decltype(std::declval<Imf::IStream&>().tellg());
    Position tellg() override { return Position(at_); }
    void seekg(Position to) override { at_ = std::min(std::size_t(to), bytes_.size()); }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

std::size_t number_of_4(std::string_view bytes)
{
    std::size_t number = 0;
    for (std::size_t k = 4; k > 0; --k)
        number = number << 8 | static_cast<unsigned char>(bytes[k - 1]);
    return number;
}

/// Whether channels end where their attribute ends: each is a name and 16 bytes, and a zero ends them.
bool is_channel_list(std::string_view value)
{
    for (std::size_t at = 0;;) {
        const std::size_t end = value.find('\0', at);
        if (end == value.npos) return false;
        if (end == at) return at + 1 == value.size();
        at = end + 1 + 16;
        if (at > value.size()) return false;
    }
}

/// Whether texts, each behind its length, end where their attribute ends.
bool is_text_list(std::string_view value)
{
    while (!value.empty()) {
        if (value.size() < 4) return false;
        const std::size_t length = number_of_4(value);
        if (length > value.size() - 4) return false;
        value.remove_prefix(4 + length);
    }
    return true;
}

/// Whether OpenEXR reads as many bytes of an attribute's value as it says to have.
bool is_sound(std::string_view type, std::string_view value)
{
    constexpr auto kSizes = std::to_array<std::pair<std::string_view, std::size_t>>(
        {{"box2i", 16}, {"box2f", 16}, {"chromaticities", 32}, {"compression", 1},
            {"deepImageState", 1}, {"double", 8}, {"envmap", 1}, {"float", 4}, {"int", 4},
            {"keycode", 28}, {"lineOrder", 1}, {"m33f", 36}, {"m33d", 72}, {"m44f", 64},
            {"m44d", 128}, {"rational", 8}, {"tiledesc", 9}, {"timecode", 8}, {"v2i", 8},
            {"v2f", 8}, {"v2d", 16}, {"v3i", 12}, {"v3f", 12}, {"v3d", 24}});
    for (const auto& [name, size] : kSizes)
        if (type == name) return value.size() == size;
    if (type == "chlist") return is_channel_list(value);
    if (type == "stringvector") return is_text_list(value);
    if (type == "floatvector") return value.size() % 4 == 0;
    if (type == "preview")
        return value.size() >= 8 && number_of_4(value) < (1u << 15) &&
               number_of_4(value.substr(4)) < (1u << 15) &&
               8 + 4 * number_of_4(value) * number_of_4(value.substr(4)) == value.size();
    return type != "idmanifest"; // which packs lists of its own; others are taken as they are
}

/// Whether every attribute of the headers fits into the file, and its value into the attribute. OpenEXR gets memory
/// for as many bytes as a file says, up to 2 GB, before it looks.
///
/// source  Academy Software Foundation, "OpenEXR File Layout": attribute layout, multi-part files
bool has_whole_attributes(std::string_view bytes)
{
    constexpr std::size_t kBegin = 8;          // behind the magic number and the version
    constexpr unsigned char kMultiPart = 0x10; // of the version's second byte
    if (bytes.size() < kBegin) return false;
    const bool several = static_cast<unsigned char>(bytes[5]) & kMultiPart;
    bool in_header = false;
    for (std::size_t at = kBegin;;) {
        const std::size_t name_end = bytes.find('\0', at);
        if (name_end == bytes.npos) return false;
        if (name_end == at) { // the end of a header; of several, an empty one ends them all
            if (!several || !in_header) return true;
            in_header = false;
            ++at;
            continue;
        }
        in_header = true;
        const std::size_t type_end = bytes.find('\0', name_end + 1);
        if (type_end == bytes.npos || bytes.size() - type_end < 5) return false;
        const std::size_t size = number_of_4(bytes.substr(type_end + 1));
        at = type_end + 5;
        if (size > bytes.size() - at) return false;
        if (!is_sound(bytes.substr(name_end + 1, type_end - name_end - 1), bytes.substr(at, size)))
            return false;
        at += size;
    }
}

} // namespace

RadiancePicture decode_exr(const std::string& name, const std::string& bytes)
{
    // OpenEXR gets memory for lines of any width before it tells the size; films are no larger than this.
    [[maybe_unused]] static const bool limited = [] {
        constexpr int kMostOfAll = 1 << 16;
        Imf::Header::setMaxImageSize(kMostOfAll, kMostOfAll);
        return true;
    }();
    try {
        if (!has_whole_attributes(bytes))
            throw std::runtime_error("it is cut off, or an attribute is damaged");
        MemoryStream stream(name, bytes);
        Imf::InputFile file(stream, 0);
        const Imath::Box2i window = file.header().dataWindow();
        const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
        const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
        check_size(name, width, height);
        for (const char* channel : {"R", "G", "B"}) {
            const Imf::Channel* found = file.header().channels().findChannel(channel);
            if (!found || found->xSampling != 1 || found->ySampling != 1)
                throw FileError(fmt::format(
                    "{}: the picture has no channel {} of full size: accepted are R, G and B", name,
                    channel));
        }
        RadiancePicture picture{int(width), int(height), {}};
        picture.radiance.resize(std::size_t(width) * std::size_t(height));
        constexpr std::size_t kPixel = sizeof(glm::vec3);
        const std::ptrdiff_t before =
            -(std::ptrdiff_t(window.min.y) * std::ptrdiff_t(width) + window.min.x) *
            std::ptrdiff_t(kPixel);
        char* const first = reinterpret_cast<char*>(picture.radiance.data()) + before;
        Imf::FrameBuffer buffer;
        const char* const names[] = {"R", "G", "B"};
        for (std::size_t c = 0; c < 3; ++c)
            buffer.insert(names[c], Imf::Slice(Imf::FLOAT, first + c * sizeof(float), kPixel,
                                        kPixel * std::size_t(width)));
        file.setFrameBuffer(buffer);
        file.readPixels(window.min.y, window.max.y);
        return picture;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw FileError(
            fmt::format("{}: not an OpenEXR picture, or a damaged one ({})", name, error.what()));
    }
}

std::shared_ptr<const EnvironmentMap> load_environment(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending != ".hdr" && ending != ".exr")
        throw ArgumentError(
            fmt::format("{}: unknown ending '{}' for an environment: accepted are .hdr and .exr",
                path, ending));
    const std::string bytes = read_whole_file(path);
    const RadiancePicture picture =
        ending == ".hdr" ? decode_radiance(path, bytes) : decode_exr(path, bytes);
    return std::make_shared<const EnvironmentMap>(
        path, picture.width, picture.height, picture.radiance);
}

} // namespace firsthit
