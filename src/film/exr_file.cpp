// exr_file.cpp - writes planes as OpenEXR.
#include "io/output_file.h"
#include "film/exr_stream.h"
#include "film/picture_files.h"

#include <firsthit/error.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include <exception>

namespace firsthit {

namespace {

void insert_slices(
    const PlaneView& plane, const std::vector<std::string>& names, Imf::FrameBuffer& buffer)
{
    const bool items = !plane.item.empty();
    const Imf::PixelType type = items ? Imf::UINT : Imf::FLOAT;
    const void* data = items ? static_cast<const void*>(plane.item.data())
                             : static_cast<const void*>(plane.value.data());
    const std::size_t x_stride = 4 * static_cast<std::size_t>(plane.channels);
    const std::size_t y_stride = x_stride * static_cast<std::size_t>(plane.width);
    // OpenEXR's slices are used for reading as well, so they are not const.
    char* first = const_cast<char*>(static_cast<const char*>(data));
    for (std::size_t c = 0; c < names.size(); ++c)
        buffer.insert(names[c], Imf::Slice(type, first + 4 * c, x_stride, y_stride));
}

} // namespace

void write_exr(
    const PlaneView& plane, const std::vector<std::string>& channel_names, const std::string& path)
{
    const ExrPlane one{plane, channel_names};
    write_exr(std::span(&one, 1), path);
}

void write_exr(std::span<const ExrPlane> planes, const std::string& path)
{
    const int width = planes[0].plane.width, height = planes[0].plane.height;
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1; // three times as fast as the default; files are 3% larger
    Imf::FrameBuffer buffer;
    for (const ExrPlane& plane : planes) {
        const Imf::Channel channel(plane.plane.item.empty() ? Imf::FLOAT : Imf::UINT);
        for (const std::string& name : plane.channel_names) header.channels().insert(name, channel);
        insert_slices(plane.plane, plane.channel_names, buffer);
    }

    OutputFile file(path);
    try {
        ExrStream stream(file);
        Imf::OutputFile exr(stream, header);
        exr.setFrameBuffer(buffer);
        exr.writePixels(height);
    } catch (const std::exception& error) {
        // If writing the file failed, commit() throws the better message.
        if (!file.failed())
            throw FileError(fmt::format("{}: cannot write: {}", path, error.what()));
    }
    file.commit();
}

void write_rgba_exr(const PlaneView& color, std::span<const float> alpha, const std::string& path)
{
    const ExrPlane planes[] = {{color, {"R", "G", "B"}},
        {{.width = color.width, .height = color.height, .channels = 1, .value = alpha}, {"A"}}};
    write_exr(planes, path);
}

} // namespace firsthit
