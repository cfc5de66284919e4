// raw_picture.cpp - what kinds of files pictures have, and how each is written.
#include "film/join/raw_picture.h"

#include "film/exr_stream.h"
#include "film/png_rows.h"
#include "io/npy_header.h"
#include "io/output_file.h"

#include <firsthit/error.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <exception>

namespace firsthit {
namespace {

std::size_t exr_bytes(int type)
{
    return type == Imf::HALF ? 2 : 4;
}

void write_raw(const RawPicture& picture, const RawPng& kind, const std::string& path)
{
    const std::size_t row_bytes = picture.pixel_bytes * static_cast<std::size_t>(picture.width);
    const auto fill = [&](int y, std::span<std::uint8_t> bytes) {
        std::copy_n(picture.bytes.data() + static_cast<std::size_t>(y) * row_bytes, row_bytes,
            bytes.data());
    };
    write_png_rows({.width = picture.width,
                       .height = picture.height,
                       .color_type = kind.color_type,
                       .bit_depth = kind.bit_depth,
                       .row_bytes = row_bytes,
                       .fill = fill},
        path);
}

void write_raw(const RawPicture& picture, const RawExr& kind, const std::string& path)
{
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1; // as write_exr
    Imf::FrameBuffer buffer;
    // OpenEXR's slices are used for reading as well, so they are not const.
    char* place = reinterpret_cast<char*>(const_cast<std::uint8_t*>(picture.bytes.data()));
    for (const auto& [name, type] : kind.channels) {
        const auto pixel_type = static_cast<Imf::PixelType>(type);
        header.channels().insert(name, Imf::Channel(pixel_type));
        buffer.insert(name, Imf::Slice(pixel_type, place, picture.pixel_bytes,
                                picture.pixel_bytes * static_cast<std::size_t>(picture.width)));
        place += exr_bytes(type);
    }
    OutputFile file(path);
    try {
        ExrStream stream(file);
        Imf::OutputFile exr(stream, header);
        exr.setFrameBuffer(buffer);
        exr.writePixels(picture.height);
    } catch (const std::exception& error) {
        // If writing the file failed, commit() throws the better message.
        if (!file.failed())
            throw FileError(fmt::format("{}: cannot write: {}", path, error.what()));
    }
    file.commit();
}

void write_raw(const RawPicture& picture, const RawNpy& kind, const std::string& path)
{
    const std::string shape =
        kind.values == 0 ? fmt::format("({}, {})", picture.height, picture.width)
                         : fmt::format("({}, {}, {})", picture.height, picture.width, kind.values);
    const std::string header = npy_header(kind.type, shape);
    OutputFile file(path);
    file.write(header.data(), header.size());
    file.write(picture.bytes.data(), picture.bytes.size());
    file.commit();
}

std::string text_of(const RawPng& kind)
{
    const char* channels = kind.color_type == PNG_COLOR_TYPE_GRAY         ? "grey"
                           : kind.color_type == PNG_COLOR_TYPE_GRAY_ALPHA ? "grey and alpha"
                           : kind.color_type == PNG_COLOR_TYPE_RGB        ? "RGB"
                                                                          : "RGBA";
    return fmt::format("PNG, {} bits, {}", kind.bit_depth, channels);
}

std::string text_of(const RawExr& kind)
{
    std::string text = "OpenEXR";
    for (const auto& [name, type] : kind.channels)
        text += fmt::format(", {} {}", name,
            type == Imf::HALF    ? "half"
            : type == Imf::FLOAT ? "float"
                                 : "uint");
    return text;
}

std::string text_of(const RawNpy& kind)
{
    return kind.values == 0 ? fmt::format("NumPy, {}", kind.type)
                            : fmt::format("NumPy, {} x {}", kind.values, kind.type);
}

} // namespace

std::string kind_text(const RawKind& kind)
{
    return std::visit([](const auto& of_file) { return text_of(of_file); }, kind);
}

void write_raw_picture(const RawPicture& picture, const std::string& path)
{
    std::visit([&](const auto& kind) { write_raw(picture, kind, path); }, picture.kind);
}

void check_raw_size(const std::string& path, const glm::ivec2& found, const glm::ivec2& size)
{
    if (found != size)
        throw FileError(fmt::format(
            "{}: has {}x{} pixels, and its region {}x{}", path, found.x, found.y, size.x, size.y));
}

} // namespace firsthit
