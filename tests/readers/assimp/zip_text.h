// zip_text.h - small ZIP archives for tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit::test {

struct ZipPart {
    std::string name;
    std::string text;
};

inline std::string little_endian(std::size_t number, int count)
{
    std::string bytes;
    for (int k = 0; k < count; ++k) bytes += static_cast<char>(number >> (8 * k) & 255);
    return bytes;
}

/// source  ISO/IEC 8802-3, the checksum that ZIP uses
inline std::uint32_t crc_of(std::string_view text)
{
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : text) {
        crc ^= static_cast<unsigned char>(c);
        for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
    }
    return ~crc;
}

/// An archive of parts. Packed ones are blocks that are not made shorter, of the method "deflate".
inline std::string zip_of(const std::vector<ZipPart>& parts, bool is_packed)
{
    std::string bytes, directory;
    for (const ZipPart& part : parts) {
        std::string data = part.text;
        if (is_packed) {
            data = '\1' + little_endian(part.text.size(), 2) +
                   little_endian(~part.text.size() & 0xFFFF, 2) + part.text;
        }
        const std::string about =
            little_endian(20, 2) + little_endian(0, 2) + little_endian(is_packed ? 8 : 0, 2) +
            little_endian(0, 4) + little_endian(crc_of(part.text), 4) +
            little_endian(data.size(), 4) + little_endian(part.text.size(), 4) +
            little_endian(part.name.size(), 2) + little_endian(0, 2);
        directory += "PK\1\2" + little_endian(20, 2) + about + little_endian(0, 2) +
                     little_endian(0, 2) + little_endian(0, 2) + little_endian(0, 4) +
                     little_endian(bytes.size(), 4) + part.name;
        bytes += "PK\3\4" + about + part.name + data;
    }
    return bytes + directory + "PK\5\6" + little_endian(0, 4) + little_endian(parts.size(), 2) +
           little_endian(parts.size(), 2) + little_endian(directory.size(), 4) +
           little_endian(bytes.size(), 4) + little_endian(0, 2);
}

/// A 3MF file of one triangle from (0, 0, 0) to 2 along x and 1 along z.
/// about  what stands in the element model, as R"(unit="inch")"
inline std::string triangle_3mf(const std::string& about, bool is_packed)
{
    return zip_of(
        {{"[Content_Types].xml",
             R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
             R"(<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
             R"(<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
            {"_rels/.rels",
                R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)"
                R"(<Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
            {"3D/3dmodel.model",
                R"(<?xml version="1.0"?><model )" + about +
                    R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)"
                    R"(<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
                    R"(<vertex x="2" y="0" z="0"/><vertex x="0" y="0" z="1"/></vertices>)"
                    R"(<triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object></resources>)"
                    R"(<build><item objectid="1"/></build></model>)"}},
        is_packed);
}

} // namespace firsthit::test
