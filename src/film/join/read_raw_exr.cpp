// read_raw_exr.cpp - an .exr's channels as its file holds them.
#include "film/join/raw_picture.h"

#include <firsthit/error.h>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <fmt/format.h>

#include <exception>

namespace firsthit {
namespace {

/// Of a file of one part with channels of full resolution.
RawPicture picture_of(const Imf::Header& header, const std::string& path, const glm::ivec2& size)
{
    const Imath::Box2i window = header.dataWindow();
    const auto wide = std::int64_t(window.max.x) - window.min.x + 1;
    const auto high = std::int64_t(window.max.y) - window.min.y + 1;
    if (wide > 65536 || high > 65536 || wide < 1 || high < 1)
        throw FileError(fmt::format("{}: has {}x{} pixels", path, wide, high));
    check_raw_size(path, {int(wide), int(high)}, size);
    RawPicture picture;
    picture.width = int(wide);
    picture.height = int(high);
    RawExr kind;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
            throw FileError(fmt::format(
                "{}: channel {} does not have a value for each pixel", path, channel.name()));
        kind.channels.emplace_back(channel.name(), int(channel.channel().type));
        picture.pixel_bytes += channel.channel().type == Imf::HALF ? 2 : 4;
    }
    picture.kind = std::move(kind);
    return picture;
}

} // namespace

RawPicture read_raw_exr(const std::string& path, const glm::ivec2& size)
{
    try {
        Imf::MultiPartInputFile file(path.c_str());
        if (file.parts() != 1)
            throw FileError(fmt::format(
                "{}: has {} parts: accepted are OpenEXR files of one part", path, file.parts()));
        RawPicture picture = picture_of(file.header(0), path, size);
        const std::size_t row_bytes = picture.pixel_bytes * static_cast<std::size_t>(picture.width);
        picture.bytes.resize(row_bytes * static_cast<std::size_t>(picture.height));
        const Imath::Box2i window = file.header(0).dataWindow();

        // A slice begins where pixel (0, 0) would be.
        Imf::FrameBuffer buffer;
        auto* place = reinterpret_cast<char*>(picture.bytes.data());
        for (const auto& [name, type] : std::get<RawExr>(picture.kind).channels) {
            buffer.insert(name, Imf::Slice::Make(static_cast<Imf::PixelType>(type), place, window,
                                    picture.pixel_bytes, row_bytes));
            place += type == Imf::HALF ? 2 : 4;
        }
        Imf::InputPart part(file, 0);
        part.setFrameBuffer(buffer);
        part.readPixels(window.min.y, window.max.y);
        return picture;
    } catch (const FileError&) {
        throw;
    } catch (const std::exception& error) {
        throw FileError(fmt::format("{}: cannot be read as OpenEXR: {}", path, error.what()));
    }
}

} // namespace firsthit
