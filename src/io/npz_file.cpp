// npz_file.cpp - several NumPy arrays in a ZIP archive without compression.
//
// source  PKWARE, "APPNOTE.TXT - .ZIP File Format Specification", 4.3 (local headers, directory, its end); the CRC-32
//         of ISO 3309, bit by bit reversed
#include "io/npy_header.h"
#include "io/output_file.h"

#include <firsthit/error.h>
#include <firsthit/npz.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>

namespace firsthit {
namespace {

constexpr std::uint64_t kMostBytes = 0xFFFFFFFF; // of sizes and places

constexpr std::array<std::uint32_t, 256> make_crc_table()
{
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ ((value & 1) != 0 ? 0xEDB88320u : 0);
        table[byte] = value;
    }
    return table;
}

class Crc32 {
  public:
    void add(const void* data, std::size_t bytes)
    {
        static constexpr std::array<std::uint32_t, 256> kTable = make_crc_table();
        const auto* byte = static_cast<const unsigned char*>(data);
        for (std::size_t k = 0; k < bytes; ++k)
            state_ = kTable[(state_ ^ byte[k]) & 255] ^ (state_ >> 8);
    }
    std::uint32_t value() const { return ~state_; }

  private:
    std::uint32_t state_ = 0xFFFFFFFF;
};

/// Numbers, little endian.
class ZipRecord {
  public:
    ZipRecord& two(std::uint32_t value) { return add(value, 2); }
    ZipRecord& four(std::uint64_t value) { return add(value, 4); }
    ZipRecord& text(const std::string& text)
    {
        bytes_ += text;
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

  private:
    ZipRecord& add(std::uint64_t value, int bytes)
    {
        for (int k = 0; k < bytes; ++k) bytes_ += char(value >> 8 * k & 255);
        return *this;
    }
    std::string bytes_;
};

struct ZipEntry {
    std::string name;
    std::uint32_t crc;
    std::uint64_t bytes, place;
};

/// What local header and directory say alike: version 2.0, stored, 1980-01-01, sizes, length of the name.
void add_common(ZipRecord& record, const ZipEntry& entry)
{
    record.two(20)
        .two(0)
        .two(0)
        .two(0)
        .two(0x21)
        .four(entry.crc)
        .four(entry.bytes)
        .four(entry.bytes);
    record.two(std::uint32_t(entry.name.size())).two(0);
}

std::string shape_of(const NpzArray& array)
{
    return array.shape.size() == 1 ? fmt::format("({},)", array.shape[0])
                                   : fmt::format("({})", fmt::join(array.shape, ", "));
}

void check_size(const NpzArray& array)
{
    std::size_t values = 1;
    for (const std::size_t length : array.shape) values *= length;
    const std::size_t size = std::size_t(array.type.back() - '0');
    if (values * size != array.data.size())
        throw ArgumentError(fmt::format("array {}: {} bytes for the shape {} of {}", array.name,
            array.data.size(), shape_of(array), array.type));
}

} // namespace

void write_npz(const std::string& path, std::span<const NpzArray> arrays)
{
    for (const NpzArray& array : arrays) check_size(array);
    OutputFile file(path);
    std::vector<ZipEntry> entries;
    std::uint64_t place = 0;
    const auto write = [&](const void* data, std::size_t bytes) {
        place += bytes;
        if (place > kMostBytes)
            throw FileError(fmt::format("{}: larger than 4 GiB, which a .npz file here cannot be: "
                                        "write fewer rays at a time",
                path));
        file.write(data, bytes);
    };
    for (const NpzArray& array : arrays) {
        const std::string header = npy_header(array.type, shape_of(array));
        Crc32 crc;
        crc.add(header.data(), header.size());
        crc.add(array.data.data(), array.data.size());
        const ZipEntry entry{
            array.name + ".npy", crc.value(), header.size() + array.data.size(), place};
        ZipRecord local;
        add_common(local.four(0x04034b50), entry);
        local.text(entry.name);
        write(local.bytes().data(), local.bytes().size());
        write(header.data(), header.size());
        write(array.data.data(), array.data.size());
        entries.push_back(entry);
    }
    ZipRecord directory;
    for (const ZipEntry& entry : entries) {
        add_common(directory.four(0x02014b50).two(20), entry);
        directory.two(0).two(0).two(0).four(0).four(entry.place).text(entry.name);
    }
    const std::uint64_t directory_place = place, size = directory.bytes().size();
    const auto count = std::uint32_t(entries.size());
    directory.four(0x06054b50).two(0).two(0).two(count).two(count).four(size).four(directory_place);
    directory.two(0);
    write(directory.bytes().data(), directory.bytes().size());
    file.commit();
}

} // namespace firsthit
