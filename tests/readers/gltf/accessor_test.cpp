// accessor_test.cpp - the numbers of accessors: all types, strides, sparse elements, bounds, limits.
#include "readers/gltf/gltf_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace firsthit::gltf {
namespace {

using Floats = std::vector<float>;
using Uints = std::vector<std::uint32_t>;

std::string accessors(const std::string& entries)
{
    return ", \"accessors\": [" + entries + "]";
}

TEST(GltfAccessor, ReadsFloatsAndMatrices)
{
    Floats numbers(16);
    for (std::size_t k = 0; k < 16; ++k) numbers[k] = float(k) - 3.5f;
    const Document document =
        read_members(one_buffer(bytes_of(numbers)) +
                     accessors(
                         R"({"bufferView": 0, "componentType": 5126, "count": 1, "type": "MAT4"},
           {"bufferView": 0, "byteOffset": 4, "componentType": 5126, "count": 5, "type": "VEC3"})"));
    EXPECT_EQ(read_floats(document, 0, 16), numbers);
    const glm::mat4 matrix = read_matrices(document, 0).at(0);
    EXPECT_EQ(matrix[2][1], numbers[9]); // column 2, row 1
    EXPECT_EQ(read_floats(document, 1, 3), Floats(numbers.begin() + 1, numbers.end()));
}

TEST(GltfAccessor, ConvertsIntegers)
{
    const std::string bytes("\x00\x7f\x80\x81\xff\xff\x01\x80", 8);
    const auto read = [&](int type, int count, bool normalized) {
        const Document document = read_members(
            one_buffer(bytes) +
            accessors(R"({"bufferView": 0, "componentType": )" + std::to_string(type) +
                      R"(, "count": )" + std::to_string(count) +
                      R"(, "type": "SCALAR", "normalized": )" + (normalized ? "true}" : "false}")));
        return read_floats(document, 0, 1);
    };
    // The specification: c / 255, max(c / 127, -1), c / 65535, max(c / 32767, -1).
    EXPECT_EQ(read(5120, 5, false), (Floats{0, 127, -128, -127, -1}));
    EXPECT_EQ(read(5120, 5, true), (Floats{0, 1, -1, -1, -1 / 127.0f}));
    EXPECT_EQ(read(5121, 5, false), (Floats{0, 127, 128, 129, 255}));
    EXPECT_EQ(read(5121, 5, true), (Floats{0, 127 / 255.0f, 128 / 255.0f, 129 / 255.0f, 1}));
    EXPECT_EQ(read(5122, 4, false), (Floats{0x7f00, -32384, -1, -32767}));
    EXPECT_EQ(
        read(5122, 4, true), (Floats{0x7f00 / 32767.0f, -32384 / 32767.0f, -1 / 32767.0f, -1}));
    EXPECT_EQ(read(5123, 4, false), (Floats{0x7f00, 0x8180, 0xffff, 0x8001}));
    EXPECT_EQ(
        read(5123, 4, true), (Floats{0x7f00 / 65535.0f, 0x8180 / 65535.0f, 1, 0x8001 / 65535.0f}));
    EXPECT_EQ(read(5125, 1, false), (Floats{float(0x81807f00u)}));
}

TEST(GltfAccessor, ReadsStridesAndPaddedColumns)
{
    std::vector<std::uint8_t> bytes(24);
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = std::uint8_t(k);
    const Document strided = read_members(
        one_buffer(bytes_of(bytes), R"("byteStride": 8)") +
        accessors(
            R"({"bufferView": 0, "byteOffset": 1, "componentType": 5121, "count": 3, "type": "VEC2"})"));
    EXPECT_EQ(read_uints(strided, 0, 2), (Uints{1, 2, 9, 10, 17, 18}));
    EXPECT_EQ(read_floats(strided, 0, 2), (Floats{1, 2, 9, 10, 17, 18}));

    const Document matrices =
        read_members(one_buffer(bytes_of(bytes)) +
                     accessors(
                         R"({"bufferView": 0, "componentType": 5121, "count": 2, "type": "MAT3"},
           {"bufferView": 0, "componentType": 5121, "count": 3, "type": "MAT2"},
           {"bufferView": 0, "componentType": 5123, "count": 1, "type": "MAT3"})"));
    EXPECT_EQ(read_uints(matrices, 0, 9),
        (Uints{0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 16, 17, 18, 20, 21, 22}));
    EXPECT_EQ(read_uints(matrices, 1, 4), (Uints{0, 1, 4, 5, 8, 9, 12, 13, 16, 17, 20, 21}));
    EXPECT_EQ(read_uints(matrices, 2, 9)[3], 8u + 9u * 256u);
}

TEST(GltfAccessor, IsZeroWithoutABufferView)
{
    const Document document =
        read_members(R"("accessors": [{"componentType": 5126, "count": 2, "type": "VEC3"}])");
    EXPECT_EQ(read_floats(document, 0, 3), Floats(6, 0.0f));
}

TEST(GltfAccessor, AppliesSparseElements)
{
    const std::string values = bytes_of(Floats{1, 2, 3, 4, 5, 6});
    const std::string members =
        R"("buffers": [{"byteLength": 26, "uri": "data:;base64,)" +
        base64(values + std::string("\x01\x03", 2)) +
        R"("}], "bufferViews": [{"buffer": 0, "byteLength": 24},
        {"buffer": 0, "byteOffset": 24, "byteLength": 2}])" +
        accessors(
            R"({"componentType": 5126, "count": 4, "type": "VEC2", "sparse": {"count": 2,
            "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0, "byteOffset": 8}}},
           {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2", "sparse": {"count": 1,
            "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}}},
           {"componentType": 5126, "count": 2, "type": "SCALAR", "sparse": {"count": 2,
            "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}}})");
    const Document document = read_members(members);
    EXPECT_EQ(read_floats(document, 0, 2), (Floats{0, 0, 3, 4, 0, 0, 5, 6}));
    EXPECT_EQ(read_floats(document, 1, 2), (Floats{1, 2, 1, 2, 5, 6}));
    EXPECT_EQ(message_of<SceneError>([&] { read_floats(document, 2, 1); }),
        "t.gltf: accessors[2]: sparse index 3 is out of range (2 elements)");
}

TEST(GltfAccessor, ChecksBoundsWithoutOverflow)
{
    const std::string buffer = one_buffer(std::string(16, 'a'));
    const auto refused = [&](const std::string& entry) {
        return refusal(buffer + accessors(entry));
    };
    EXPECT_EQ(refused(R"({"bufferView": 0, "componentType": 5126, "count": 5, "type": "SCALAR"})"),
        "t.gltf: accessors[0]: needs bytes 0 to 20 of buffer view 0, which has 16");
    EXPECT_EQ(
        refused(
            R"({"bufferView": 0, "byteOffset": 9007199254740992, "componentType": 5126, "count": 1, "type": "SCALAR"})"),
        "t.gltf: accessors[0]: needs bytes 9007199254740992 to 9007199254740996 of buffer view 0, "
        "which has 16");
    EXPECT_EQ(
        refused(
            R"({"bufferView": 0, "componentType": 5126, "count": 4294967297, "type": "SCALAR"})"),
        "t.gltf: accessors[0].count: 4294967297 elements, at most 268435456 are accepted");
    EXPECT_EQ(
        refused(R"({"bufferView": 0, "componentType": 5126, "count": 1e30, "type": "SCALAR"})"),
        "t.gltf: accessors[0].count: 1e+30 is not accepted, a whole number from 0 to "
        "9007199254740992 is");
    EXPECT_EQ(refusal(R"("buffers": [{"byteLength": 4, "uri": "data:,abcd"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 9007199254740992, "byteLength": 9007199254740992}])"),
        "t.gltf: bufferViews[0]: bytes 9007199254740992 to 18014398509481984 are beyond the "
        "buffer's 4");
    EXPECT_EQ(
        refusal(
            one_buffer("abcdefgh", R"("byteStride": 4)") +
            accessors(R"({"bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC2"})")),
        "t.gltf: accessors[0]: the byteStride 4 of its buffer view is smaller than an element (8 "
        "bytes)");
}

TEST(GltfAccessor, ASmallFileTakesNoGigabytes)
{
    const auto zeros = [](const std::string& count) {
        return R"({"componentType": 5126, "count": )" + count + R"(, "type": "MAT4"})";
    };
    EXPECT_EQ(refusal(R"("accessors": [)" + zeros("2147483648") + "]"),
        "t.gltf: accessors[0].count: 2147483648 elements, at most 268435456 are accepted");
    EXPECT_EQ(refusal(R"("accessors": [)" + zeros("268435456") + "]").substr(0, 45),
        "t.gltf: accessors[0]: more than 256 MiB of ac");
    // Many small ones count together: 64 bytes a matrix.
    std::string many = zeros("1000000");
    for (int k = 1; k < 5; ++k) many += "," + zeros("1000000");
    EXPECT_EQ(refusal(R"("accessors": [)" + many + "]").substr(0, 45),
        "t.gltf: accessors[4]: more than 256 MiB of ac");
}

TEST(GltfAccessor, RefusesNumbersThatAreNotFinite)
{
    const Document document = read_members(
        one_buffer(bytes_of(Floats{1, 2, 3, std::nanf("")})) +
        accessors(
            R"({"bufferView": 0, "name": "p", "componentType": 5126, "count": 2, "type": "VEC2"})"));
    EXPECT_EQ(message_of<SceneError>([&] { read_floats(document, 0, 2); }),
        "t.gltf: accessors[0] 'p': element 1 is not finite");
}

TEST(GltfAccessor, RefusesOtherTypesThanWereAskedFor)
{
    const Document document =
        read_members(one_buffer(std::string(16, '\1')) +
                     accessors(
                         R"({"bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC3"},
           {"componentType": 7, "count": 1, "type": "VEC3"})"));
    EXPECT_EQ(message_of<FileError>([&] { read_floats(document, 0, 2); }),
        "t.gltf: accessors[0]: has 3 components, 2 were expected");
    EXPECT_EQ(message_of<FileError>([&] { read_uints(document, 0, 3); }),
        "t.gltf: accessors[0]: componentType 5126 is not accepted; accepted are 5121, 5123, 5125");
    EXPECT_EQ(message_of<FileError>([&] { read_floats(document, 1, 1); }),
        "t.gltf: accessors[1]: cannot be read: its componentType or type is unknown; accepted are "
        "5120 to 5123, "
        "5125, 5126 and SCALAR, VEC2 to VEC4, MAT2 to MAT4");
    EXPECT_EQ(document.warnings.size(), 1u);
}

TEST(GltfAccessor, ChecksIndicesAgainstVertices)
{
    const Document document = read_members(
        one_buffer(std::string("\0\1\2\0\2\3", 6)) +
        accessors(
            R"({"bufferView": 0, "componentType": 5121, "count": 6, "type": "SCALAR"},
           {"componentType": 5126, "count": 4, "type": "VEC3"})") +
        R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}, {"attributes": {"POSITION": 1}}]}])");
    const std::vector<Primitive>& primitives = document.meshes[0].primitives;
    EXPECT_EQ(read_indices(document, primitives[0], 4), (Uints{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(read_indices(document, primitives[1], 4), (Uints{0, 1, 2, 3}));
    EXPECT_EQ(message_of<SceneError>([&] { read_indices(document, primitives[0], 2); }),
        "t.gltf: accessors[0]: element 2: index 2 is out of range (2 vertices)");
}

TEST(GltfAccessor, WarnsOfWhatIsOdd)
{
    EXPECT_EQ(
        warnings_of(read_members(
            one_buffer(std::string(12, 'a'), R"("byteStride": 6)") +
            accessors(
                R"({"bufferView": 0, "byteOffset": 1, "componentType": 5126, "count": 1, "type": "SCALAR", "normalized": true},
           {"bufferView": 0, "componentType": 5121, "count": 0, "type": "SCALAR"},
           {"byteOffset": 4, "componentType": 5121, "count": 1, "type": "SCALAR"})"))),
        "t.gltf: bufferViews[0].byteStride is 6; a multiple of 4 from 4 to 252 was expected\n"
        "t.gltf: accessors[0].normalized is ignored: its components are floats or 32-bit integers\n"
        "t.gltf: accessors[0] is not aligned to its components of 4 bytes\n"
        "t.gltf: accessors[1] has no elements\n"
        "t.gltf: accessors[2].byteOffset has no buffer view\n");
}

} // namespace
} // namespace firsthit::gltf
