// jpeg_check.cpp - refuses JPEG pictures that stb_image would write past its tables for.
#include "readers/image/jpeg_check.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cstddef>

namespace firsthit {

void check_jpeg_tables(const std::string& name, std::span<const char> bytes)
{
    // ITU-T T.81, B.2.4.2. The marker FF C4 is followed by a length, then by tables: a byte that
    // names the table, the number of codes of each length from 1 to 16, the symbols. Inside coded
    // data FF is followed by 00 or a restart, so looking at every FF C4 finds all tables.
    const auto byte = [&](std::size_t at) {
        return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : std::size_t(0);
    };
    for (std::size_t marker = 0; marker + 1 < bytes.size(); ++marker) {
        if (byte(marker) != 0xFF || byte(marker + 1) != 0xC4) continue;
        const std::size_t end = marker + 2 + byte(marker + 2) * 256 + byte(marker + 3);
        for (std::size_t table = marker + 4; table < end && table < bytes.size();) {
            std::size_t codes = 0;
            for (std::size_t length = 1; length <= 16; ++length) codes += byte(table + length);
            if (codes > 256)
                throw FileError(fmt::format("{}: the JPEG picture has a Huffman table of {} codes "
                                            "at byte {}; accepted are at most 256",
                    name, codes, table));
            table += 17 + codes;
        }
    }
}

} // namespace firsthit
