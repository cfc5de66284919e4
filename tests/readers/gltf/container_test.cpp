// container_test.cpp - what is accepted as a glTF file: JSON and GLB, versions, limits.
#include "readers/gltf/gltf_text.h"

#include <gtest/gtest.h>

namespace firsthit::gltf {
namespace {

const std::string kAsset = R"({"asset": {"version": "2.0", "generator": "by hand"}})";

Document read(const std::string& bytes)
{
    return read_document("t", bytes, {});
}

std::string refused(const std::string& bytes)
{
    return message_of<FileError>([&] { read(bytes); });
}

TEST(GltfContainer, ReadsJson)
{
    const Document document = read(kAsset);
    EXPECT_EQ(document.asset.version, "2.0");
    EXPECT_EQ(document.asset.generator, "by hand");
    EXPECT_EQ(document.scene, kNone);
    EXPECT_TRUE(document.files.empty());
    EXPECT_EQ(warnings_of(document), "");
}

TEST(GltfContainer, ToleratesAByteOrderMark)
{
    EXPECT_EQ(warnings_of(read("\xEF\xBB\xBF" + kAsset)),
        "t: the JSON text begins with a byte order mark\n");
}

TEST(GltfContainer, RefusesWhatIsNoJson)
{
    EXPECT_TRUE(refused("").starts_with("t: not a glTF file: parse error at line 1"))
        << refused("");
    EXPECT_TRUE(refused("{").starts_with("t: not a glTF file: parse error")) << refused("{");
    EXPECT_EQ(refused("[1]"), "t: not a glTF file: the JSON text is no object");
    EXPECT_TRUE(refused("{\"a\": \"\xff\"}").starts_with("t: not a glTF file"))
        << refused("{\"a\": \"\xff\"}");
    EXPECT_TRUE(refused(R"({"a": 1e999})").starts_with("t: not a glTF file"))
        << refused(R"({"a": 1e999})");
}

TEST(GltfContainer, RefusesDeepNestingBeforeItIsParsed)
{
    EXPECT_EQ(refused(std::string(1000000, '[')),
        "t: JSON values are nested more than 64 deep at byte 64");
    const std::string in_text =
        R"({"asset": {"version": "2.0", "generator": ")" + std::string(100, '[') + "\\\"[\"}}";
    EXPECT_EQ(refused(in_text), "no error");
}

TEST(GltfContainer, RefusesTooManyValues)
{
    EXPECT_EQ(refused("[" + std::string((1 << 24) + 1, ',')),
        "t: 16777218 JSON values, at most 16777216 are accepted");
}

TEST(GltfContainer, NamesTheVersionThatIsNotAccepted)
{
    EXPECT_EQ(refused(R"({"asset": {"version": "1.0"}})"),
        "t: asset.version: glTF 1.0 is not accepted; accepted is 2.0");
    EXPECT_EQ(refused(R"({"asset": {"version": 1.1}})"),
        "t: asset.version: glTF 1.1 is not accepted; accepted is 2.0");
    EXPECT_EQ(refused(R"({"meshes": {"a": {}}})"),
        "t: asset.version: glTF 1.0 is not accepted; accepted is 2.0");
    EXPECT_EQ(refused(R"({"asset": {}})"), "t: asset.version: is missing; accepted is 2.0");
    EXPECT_EQ(refused("{}"), "t: asset: is missing; accepted are files of glTF 2.0");
    EXPECT_EQ(refused(R"({"asset": {"version": "2.0", "minVersion": "2.1"}})"),
        "t: asset.minVersion: glTF 2.1 is not accepted; accepted is 2.0");
    EXPECT_EQ(refused(glb("", 1)), "t: a GLB file of version 1; accepted is 2 (glTF 2.0)");
}

TEST(GltfContainer, ReadsTheChunksOfGlb)
{
    const std::string json = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 5}]})";
    const Document document = read(glb(chunk(kJsonChunk, json) + chunk(kBinChunk, "hello")));
    ASSERT_EQ(document.buffers.size(), 1u);
    EXPECT_EQ(
        std::string(document.buffers[0].bytes.begin(), document.buffers[0].bytes.end()), "hello");
    EXPECT_EQ(warnings_of(document), "");
}

TEST(GltfContainer, ToleratesOddGlbFiles)
{
    const std::string json = chunk(kJsonChunk, kAsset);
    EXPECT_EQ(
        warnings_of(read(glb(json) + "more")), "t: 4 bytes after its last chunk are not read\n");
    EXPECT_EQ(warnings_of(read(glb(json + chunk(7, "abcd")))),
        "t: a chunk of unknown type 0x00000007 is not read\n");
    EXPECT_EQ(
        warnings_of(read(glb(json + chunk(kBinChunk, "abcd")))), "t: the BIN chunk is not used\n");
    std::string unpadded = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4}]} )";
    ASSERT_NE(unpadded.size() % 4, 0u);
    const std::string first =
        little_endian(std::uint32_t(unpadded.size())) + little_endian(kJsonChunk) + unpadded;
    EXPECT_EQ(warnings_of(read(glb(first + chunk(kBinChunk, "abcd")))),
        "t: the length of a chunk is no multiple of 4\n");
    const std::string aligned = kAsset + std::string(4 - kAsset.size() % 4, ' ');
    EXPECT_EQ(warnings_of(read(glb(chunk(kJsonChunk, aligned + std::string(4, '\0'))))),
        "t: the JSON chunk is padded with zeros\n");
    std::string longer = glb(json);
    longer[8] = static_cast<char>(longer[8] + 4);
    EXPECT_EQ(warnings_of(read(longer)).substr(0, 23), "t: its header promises ");
}

TEST(GltfContainer, RefusesEveryTruncatedGlb)
{
    const std::string json = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4}],
        "bufferViews": [{"buffer": 0, "byteLength": 4}]})";
    const std::string whole = glb(chunk(kJsonChunk, json) + chunk(kBinChunk, "abcd"));
    for (std::size_t n = 0; n < whole.size(); ++n) {
        const std::string message = message_of<FileError>([&] {
            // Without the BIN chunk, the rest is a document that says that it was longer.
            if (read(whole.substr(0, n)).warnings.empty()) throw FileError("silent");
            throw FileError("warned");
        });
        EXPECT_NE(message, "silent") << n;
    }
    EXPECT_EQ(refused(whole.substr(0, 8)), "t: the GLB file ends in its header");
    EXPECT_EQ(refused(whole.substr(0, whole.size() - 1)),
        "t: the file is cut off: chunk 1 at byte " + std::to_string(whole.size() - 12) +
            " has 4 bytes, 3 are left");
    EXPECT_EQ(refused(glb("")), "t: the GLB file has no JSON chunk");
    EXPECT_EQ(refused(glb(chunk(kBinChunk, "abcd"))),
        "t: the first chunk of the GLB file is of type 0x004e4942, not JSON");
}

TEST(GltfContainer, NamesThePlaceOfAWrongMember)
{
    EXPECT_EQ(refusal(R"("nodes": [{}, {"mesh": 3}])"),
        "t.gltf: nodes[1].mesh: 3 is out of range, there are 0");
    EXPECT_EQ(refusal(R"("nodes": [{"mesh": -1}])"),
        "t.gltf: nodes[0].mesh: -1 is out of range, there are 0");
    EXPECT_EQ(refusal(R"("nodes": [7])"), "t.gltf: nodes[0]: an object was expected, not number");
    EXPECT_EQ(refusal(R"("nodes": {})"), "t.gltf: nodes: an array was expected, not object");
    EXPECT_EQ(refusal(R"("nodes": [{"name": 7}])"),
        "t.gltf: nodes[0].name: a text was expected, not number");
    EXPECT_EQ(refusal(R"("nodes": [{"scale": [1, 2]}])"),
        "t.gltf: nodes[0].scale: 2 numbers instead of 3");
    EXPECT_EQ(refusal(R"("nodes": [{"scale": [1, 2, 1e300]}])"),
        "t.gltf: nodes[0].scale: the number is too large for a float");
    EXPECT_EQ(refusal(R"("nodes": [{"children": [0.5]}])"),
        "t.gltf: nodes[0].children: 0.5 is out of range, there are 1");
    EXPECT_EQ(refusal(R"("materials": [{"doubleSided": 1}])"),
        "t.gltf: materials[0].doubleSided: true or false was expected, not number");
    EXPECT_EQ(refusal(R"("scene": 0)"), "t.gltf: scene: 0 is out of range, there are 0");
    EXPECT_EQ(refusal(R"("nodes": [{"extensions": 5}])"),
        "t.gltf: nodes[0].extensions: an object was expected, not number");
}

TEST(GltfContainer, KeepsControlCharactersOutOfMessages)
{
    const Document document = read_members(R"("extensionsUsed": ["A\u001b[2J\n"])");
    EXPECT_EQ(warnings_of(document),
        "t.gltf: the extension 'A?[2J?' is not supported: what it describes is not shown\n");
}

TEST(GltfContainer, NamesExtensionsThatItLacks)
{
    EXPECT_EQ(refusal(R"("extensionsUsed": ["X"], "extensionsRequired": ["X"])"),
        "t.gltf: extensionsRequired: the extension 'X' is not supported");
    EXPECT_EQ(
        warnings_of(read_members(
            R"("extensionsUsed": ["X", "KHR_materials_iridescence", "KHR_materials_unlit"])")),
        "t.gltf: the extension 'X' is not supported: what it describes is not shown\n"
        "t.gltf: the extension 'KHR_materials_iridescence' is not supported: thin films have no "
        "colours\n");
    const std::string basis =
        R"("extensionsUsed": ["KHR_texture_basisu"], "extensionsRequired": ["KHR_texture_basisu"])";
    EXPECT_EQ(warnings_of(read_members(basis)),
        "t.gltf: the extension 'KHR_texture_basisu' is not supported: textures in KTX2 (Basis "
        "Universal) are not shown\n");
    EXPECT_EQ(warnings_of(read_members(R"("extensionsUsed": ["KHR_xmp", "KHR_xmp"])")),
        "t.gltf: extensionsUsed names 'KHR_xmp' twice\n");
    EXPECT_EQ(warnings_of(read_members(R"("extensionsRequired": ["KHR_materials_ior"])")),
        "t.gltf: the extension 'KHR_materials_ior' is in extensionsRequired, but not in "
        "extensionsUsed\n");
}

} // namespace
} // namespace firsthit::gltf
