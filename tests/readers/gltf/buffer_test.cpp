// buffer_test.cpp - where the bytes of a glTF document come from.
#include "readers/gltf/gltf_text.h"
#include "readers/gltf/data/uri.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace firsthit::gltf {
namespace {

std::string text_of(std::span<const char> bytes)
{
    return {bytes.begin(), bytes.end()};
}

std::string buffer_of(const std::string& uri)
{
    const Document document =
        read_members(R"("buffers": [{"byteLength": 5, "uri": ")" + uri + R"("}])");
    return text_of(document.buffers[0].bytes);
}

TEST(GltfUri, DecodesDataInAllSpellings)
{
    EXPECT_EQ(buffer_of("data:application/octet-stream;base64,aGVsbG8="), "hello");
    EXPECT_EQ(buffer_of("data:;base64,aGVsbG8"), "hello");
    EXPECT_EQ(buffer_of("DATA:;base64,aGVsbG8%3D"), "hello");
    EXPECT_EQ(buffer_of("data:,hel%6Co"), "hello");
    EXPECT_EQ(buffer_of("data:application/gltf-buffer;charset=utf-8,hello"), "hello");
    std::string mime_type;
    EXPECT_EQ(decode_data_uri("data:image/png;base64,AP8-_w==", mime_type),
        std::string("\0\xff\x3e\xff", 4));
    EXPECT_EQ(mime_type, "image/png");
    for (std::size_t n = 0; n < 9; ++n) {
        const std::string bytes = std::string("\xff\x00\x80zyxwvu", 9).substr(0, n);
        EXPECT_EQ(decode_data_uri("data:;base64," + base64(bytes), mime_type), bytes);
    }
}

TEST(GltfUri, RefusesDamagedData)
{
    for (const char* uri :
        {"data:;base64,a", "data:;base64,a*b=", "data:;base64", "data:;base64,aGV sbG8="})
        EXPECT_EQ(
            refusal(R"("buffers": [{"byteLength": 1, "uri": ")" + std::string(uri) + R"("}])"),
            "t.gltf: buffers[0].uri: the data URI is damaged")
            << uri;
}

TEST(GltfUri, KnowsProtocolsFromFiles)
{
    EXPECT_TRUE(has_scheme("https://example.org/a.bin"));
    EXPECT_TRUE(has_scheme("file:///a.bin"));
    EXPECT_FALSE(has_scheme("a/b:c.bin"));
    EXPECT_FALSE(has_scheme("C:/a.bin"));
    EXPECT_EQ(refusal(R"("buffers": [{"byteLength": 1, "uri": "http://example.org/a.bin"}])"),
        "t.gltf: buffers[0].uri: 'http://example.org/a.bin' is not accepted; accepted are data "
        "URIs and names of "
        "files beside the document");
}

TEST(GltfBuffer, ReadsFilesBesideTheDocument)
{
    const TemporaryFolder folder;
    folder.write("a b.bin", "one");
    folder.write("sub/\xC3\xA4.bin", "two");
    folder.write("100%25.bin", "raw");
    const std::filesystem::path path =
        folder.write("t.gltf", R"({"asset": {"version": "2.0"}, "buffers": [
        {"byteLength": 3, "uri": "a%20b.bin"}, {"byteLength": 3, "uri": "sub/\u00e4.bin"},
        {"byteLength": 3, "uri": "sub/%C3%A4.bin"}, {"byteLength": 3, "uri": "100%25.bin"},
        {"byteLength": 3, "uri": "sub\\\u00e4.bin"}]})");
    const Document document = read_document(path);
    std::string all;
    for (const Buffer& buffer : document.buffers) all += text_of(buffer.bytes) + " ";
    EXPECT_EQ(all, "one two two raw two ");
    // A file that is named twice is read once.
    const std::vector<std::string> files = {
        path.string(), folder / "a b.bin", folder / "sub/\xC3\xA4.bin", folder / "100%25.bin"};
    EXPECT_EQ(document.files, files);
    EXPECT_EQ(document.buffers[1].storage, document.buffers[2].storage);
}

TEST(GltfBuffer, NamesMissingFiles)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.write("t.gltf",
        R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 3, "uri": "gone.bin"}]})");
    EXPECT_EQ(message_of<FileError>([&] { read_document(path); }),
        path.string() + ": buffers[0].uri: " + (folder / "gone.bin") + ": no such file");
    EXPECT_EQ(message_of<FileError>([&] { read_document(folder / "t.glb"); }),
        (folder / "t.glb") + ": no such file");
}

TEST(GltfBuffer, MayHaveNoBytes)
{
    const Document document =
        read_members(R"("buffers": [{"byteLength": 4}, {"byteLength": 4, "uri": "a.bin"},
        {"byteLength": 8, "uri": "data:,abcd"}],
        "bufferViews": [{"buffer": 0, "byteLength": 4}, {"buffer": 1, "byteLength": 4}, {"buffer": 2, "byteLength": 8},
            {"buffer": 2, "byteLength": 4}],
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": 1, "type": "SCALAR"},
            {"bufferView": 1, "componentType": 5121, "count": 1, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5121, "count": 1, "type": "SCALAR"},
            {"bufferView": 3, "componentType": 5121, "count": 4, "type": "SCALAR"}])");
    const auto refused = [&](int accessor) {
        return message_of<FileError>([&] { read_floats(document, accessor, 1); });
    };
    EXPECT_EQ(refused(0), "t.gltf: accessors[0]: its bytes are missing: its buffer has no uri");
    EXPECT_EQ(refused(1), "t.gltf: accessors[1]: its bytes are missing: the file 'a.bin' is not "
                          "read without a folder");
    EXPECT_EQ(refused(2),
        "t.gltf: accessors[2]: its bytes are missing: its buffer ends after 4 of 8 bytes");
    EXPECT_EQ(refused(3), "no error");
    EXPECT_EQ(warnings_of(document), "t.gltf: buffers[2] has 4 bytes instead of 8\n");
}

TEST(GltfBuffer, StaysValidInCopiesOfTheDocument)
{
    Document copy;
    {
        const Document document = read_members(one_buffer("abcd"));
        copy = document;
    }
    EXPECT_EQ(text_of(copy.buffer_views[0].bytes), "abcd");
}

} // namespace
} // namespace firsthit::gltf
