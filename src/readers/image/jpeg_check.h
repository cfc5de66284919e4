// jpeg_check.h - refuses JPEG pictures that stb_image would write past its tables for.
#pragma once

#include <span>
#include <string>

namespace firsthit {

/// Every Huffman table in the file has at most 256 codes, as the format demands. Bytes that are no
/// JPEG at all pass.
/// throws  FileError with the offset of the table
void check_jpeg_tables(const std::string& name, std::span<const char> bytes);

} // namespace firsthit
