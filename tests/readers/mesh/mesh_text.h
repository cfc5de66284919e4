// mesh_text.h - small mesh files for tests, and what went wrong with them.
#pragma once

#include "readers/mesh_file.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace firsthit::test {

inline Scene read(
    const std::string& bytes, const std::string& extension, const LoadSettings& settings = {})
{
    return read_mesh(bytes, extension, "m" + extension, {}, settings);
}

/// The message of the error of that kind, which must be thrown.
template <class Kind>
std::string error_of(const std::string& bytes, const std::string& extension)
{
    try {
        read(bytes, extension);
    } catch (const Kind& error) {
        return error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "another kind of error: " << error.what();
        return {};
    }
    ADD_FAILURE() << "no error";
    return {};
}

inline void expect_in(const std::string& message, const std::string& part)
{
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' in: " << message;
}

template <class T>
void append(std::string& bytes, T value)
{
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
}

/// A binary STL file of `facets` triangles side by side along x.
inline std::string binary_stl(std::uint32_t facets)
{
    std::string bytes(80, 's');
    append(bytes, facets);
    for (std::uint32_t f = 0; f < facets; ++f) {
        const auto x = static_cast<float>(f);
        for (const float value : {0.f, 0.f, 1.f, x, 0.f, 0.f, x + 1, 0.f, 0.f, x, 1.f, 0.f})
            append(bytes, value);
        append(bytes, std::uint16_t(0));
    }
    return bytes;
}

/// A unit cube of 6 quads, wound outwards, with nothing but positions.
inline const char* const kCubeObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                    "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\n"
                                    "f 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

/// A header for `vertices` points x y z and `faces` lists.
inline std::string ply_header(const std::string& format, const std::string& vertices,
    const std::string& faces, const std::string& more = "")
{
    return "ply\nformat " + format + " 1.0\ncomment made for a test\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\n" + more + "element face " +
           faces + "\nproperty list uchar int vertex_indices\nend_header\n";
}

} // namespace firsthit::test
