// compressed_test.cpp - geometry packed by Draco and meshoptimizer.
#include "readers/gltf/data/draco.h"
#include "readers/gltf/gltf_text.h"
#include "readers/gltf/data/meshopt.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace firsthit::gltf {
namespace {

std::string seed(const std::string& name)
{
    std::string path = FIRSTHIT_SEEDS;
    path.append("/").append(name);
    return firsthit::bytes_of(path);
}

/// The corners of a square's triangles, in the order of its indices.
std::vector<float> corners(const Document& document, const Primitive& primitive)
{
    const int position = primitive.attributes.at("POSITION");
    const std::vector<float> p = read_floats(document, position, 3);
    std::vector<float> corners;
    for (const std::uint32_t index : read_indices(document, primitive, p.size() / 3))
        corners.insert(corners.end(), {p[3 * index], p[3 * index + 1], p[3 * index + 2]});
    return corners;
}

TEST(GltfDraco, UnpacksAttributesAndIndices)
{
    if (!can_decode_draco()) GTEST_SKIP() << "built without Draco";
    for (const char* name : {"draco.glb", "draco_sequential.glb"}) {
        const Document document = read_document(name, seed(name), {});
        EXPECT_EQ(warnings_of(document), "");
        const Primitive& primitive = document.meshes[0].primitives[0];
        const std::vector<float> found = corners(document, primitive);
        ASSERT_EQ(found.size(), 18u);
        // The two triangles of the unit square, each turned as Draco likes, within its 8 bits.
        double area = 0;
        for (std::size_t k = 0; k < 18; k += 9)
            area += 0.5 * ((found[k + 3] - found[k]) * (found[k + 7] - found[k + 1]) -
                              (found[k + 6] - found[k]) * (found[k + 4] - found[k + 1]));
        EXPECT_NEAR(area, 1.0, 0.01);
        EXPECT_EQ(document.accessors[std::size_t(primitive.attributes.at("TEXCOORD_0"))].count, 4u);
        EXPECT_EQ(document.accessors.size(), 3u);
    }
}

TEST(GltfDraco, RefusesDamagedData)
{
    if (!can_decode_draco()) GTEST_SKIP() << "built without Draco";
    std::string bytes = seed("draco.glb");
    bytes[bytes.find("DRACO")] = 'X';
    EXPECT_EQ(message_of<FileError>([&] { read_document("t", bytes, {}); }),
        "t: meshes[0].primitives[0].KHR_draco_mesh_compression: the compressed data are no "
        "triangle mesh");
    DracoMesh mesh;
    EXPECT_EQ(decode_draco({}, {}, mesh), "the compressed data are no triangle mesh");
}

TEST(GltfDraco, RefusesMoreTrianglesThanBytesCanHold)
{
    if (!can_decode_draco()) GTEST_SKIP() << "built without Draco";
    // Version 2.2, a mesh, sequential, no metadata; 2^28 - 1 faces and 3 points.
    const std::string bytes("DRACO\x02\x02\x01\x00\x00\x00\xff\xff\xff\x7f\x03\x00", 17);
    EXPECT_EQ(check_draco_sizes(bytes),
        "the data promise 268435455 triangles and 3 vertices, 17 bytes cannot hold them");
}

TEST(GltfDraco, ShowsUncompressedDataInstead)
{
    const std::string buffer = one_buffer(bytes_of(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const Document document =
        read_members(buffer + R"(, "extensionsUsed": ["KHR_draco_mesh_compression"],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "extensions": {"KHR_draco_mesh_compression":
            {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}])");
    EXPECT_EQ(corners(document, document.meshes[0].primitives[0]),
        (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    const std::string reason =
        can_decode_draco() ? "the compressed data are no triangle mesh" : kNoDraco;
    EXPECT_EQ(warnings_of(document),
        "t.gltf: meshes[0].primitives[0].KHR_draco_mesh_compression: " + reason +
            "; the uncompressed data are shown\n");
}

TEST(GltfMeshopt, UnpacksAllModes)
{
    if (!can_unpack_meshopt()) GTEST_SKIP() << "built without meshoptimizer";
    const Document document = read_document("t", seed("meshopt.glb"), {});
    EXPECT_EQ(warnings_of(document), "");
    EXPECT_EQ(read_floats(document, 0, 3),
        (std::vector<float>{0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0}));
    // TRIANGLES may turn each triangle; INDICES keeps the order.
    EXPECT_EQ(read_uints(document, 5, 1), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    std::vector<std::uint32_t> index = read_uints(document, 4, 1);
    std::sort(index.begin(), index.end());
    EXPECT_EQ(index, (std::vector<std::uint32_t>{0, 0, 1, 2, 2, 3}));
}

TEST(GltfMeshopt, RefusesLayoutsThatItsDecodersMustNotSee)
{
    const auto wrong = [](std::size_t stride, std::size_t count, const char* mode,
                           const char* filter) {
        return check_meshopt(
            {.stride = stride, .count = count, .mode = mode, .filter = filter}, 100);
    };
    EXPECT_EQ(wrong(8, 10, "ATTRIBUTES", "OCTAHEDRAL"), "");
    EXPECT_EQ(wrong(4, 100, "INDICES", ""), "");
    EXPECT_EQ(wrong(8, 1000000, "ATTRIBUTES", ""),
        "count 1000000 is more than 100 compressed bytes can hold");
    EXPECT_EQ(
        wrong(4, 303, "TRIANGLES", ""), "count 303 is more than 100 compressed bytes can hold");
    EXPECT_EQ(wrong(4, 101, "INDICES", ""), "count 101 is more than 100 compressed bytes can hold");
    EXPECT_EQ(wrong(6, 10, "ATTRIBUTES", ""),
        "byteStride 6 is not accepted; accepted are multiples of 4 up to 256");
    EXPECT_EQ(wrong(260, 10, "ATTRIBUTES", ""),
        "byteStride 260 is not accepted; accepted are multiples of 4 up to 256");
    EXPECT_EQ(wrong(8, 10, "INDICES", ""), "byteStride 8 is not accepted; accepted are 2 and 4");
    EXPECT_EQ(wrong(4, 10, "TRIANGLES", ""), "count 10 is no multiple of 3");
    EXPECT_EQ(wrong(4, 9, "TRIANGLES", "OCTAHEDRAL"),
        "the filter 'OCTAHEDRAL' is not accepted for indices");
    EXPECT_EQ(wrong(4, 9, "POINTS", ""),
        "the mode 'POINTS' is not accepted; accepted are ATTRIBUTES, TRIANGLES, INDICES");
    EXPECT_EQ(wrong(12, 9, "ATTRIBUTES", "OCTAHEDRAL"),
        "byteStride 12 is not accepted for OCTAHEDRAL; accepted are 4 and 8");
    EXPECT_EQ(wrong(4, 9, "ATTRIBUTES", "QUATERNION"),
        "byteStride 4 is not accepted for QUATERNION; accepted is 8");
    EXPECT_EQ(wrong(4, 9, "ATTRIBUTES", "COLOR"), "the filter 'COLOR' is not accepted; accepted "
                                                  "are NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL");
}

TEST(GltfMeshopt, RefusesDamagedData)
{
    if (!can_unpack_meshopt()) GTEST_SKIP() << "built without meshoptimizer";
    const std::string members =
        one_buffer("abcdefgh") + R"(, "extensionsUsed": ["EXT_meshopt_compression"])";
    const std::size_t end = members.find("}]", members.find("bufferViews"));
    const auto view = [&](int count) {
        return members.substr(0, end) +
               R"(, "extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteLength": 8,
            "byteStride": 4, "count": )" +
               std::to_string(count) + R"(, "mode": "ATTRIBUTES"}}}])" + members.substr(end + 2);
    };
    EXPECT_EQ(refusal(view(2)),
        "t.gltf: bufferViews[0].EXT_meshopt_compression: the compressed data are damaged");
    EXPECT_EQ(refusal(view(1)), "t.gltf: bufferViews[0].EXT_meshopt_compression: unpacks to 4 "
                                "bytes, the buffer view has 8");
}

} // namespace
} // namespace firsthit::gltf
