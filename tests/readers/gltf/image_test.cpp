// image_test.cpp - the pictures of glTF documents, told apart by content.
#include "readers/gltf/gltf_text.h"
#include "readers/gltf/data/images.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace firsthit::gltf {
namespace {

std::string seed(const std::string& name)
{
    std::string path = FIRSTHIT_SEEDS;
    path.append("/").append(name);
    return firsthit::bytes_of(path);
}

DecodedImage decode(const std::string& bytes, const std::string& mime_type)
{
    return decode_image(read_members(R"("images": [{"name": "i", "uri": "data:)" + mime_type +
                                     ";base64," + base64(bytes) + R"("}])"),
        0);
}

TEST(GltfImages, DecodesByContent)
{
    for (const char* name : {"picture.png", "picture.webp"}) {
        if (!FIRSTHIT_WITH_WEBP && std::string(name) == "picture.webp") continue;
        const DecodedImage image = decode(seed(name), "image/jpeg"); // not what it says
        ASSERT_TRUE(image.picture) << name << image.why_not;
        EXPECT_EQ(
            image.picture->pixel.size(), std::size_t(image.picture->width * image.picture->height));
        EXPECT_EQ(image.why_not, "");
    }
}

TEST(GltfImages, DecodesWebPExactly)
{
    if (!FIRSTHIT_WITH_WEBP) GTEST_SKIP() << "built without libwebp";
    const DecodedImage image = decode(seed("picture.webp"), "image/webp");
    ASSERT_TRUE(image.picture);
    ASSERT_EQ(image.picture->width, 4);
    ASSERT_EQ(image.picture->height, 4);
    // Written with red 16 k, green 255 - 16 k, blue 40, alpha 255 - k, without losses.
    for (std::uint32_t k = 0; k < 16; ++k)
        EXPECT_EQ(
            image.picture->pixel[k], 16 * k | (255 - 16 * k) << 8 | 40u << 16 | (255 - k) << 24)
            << k;
    const std::string whole = seed("picture.webp");
    for (std::size_t n = 0; n < whole.size() - 1; ++n)
        EXPECT_FALSE(decode(whole.substr(0, n), "image/webp").picture) << n;
    EXPECT_EQ(decode(whole.substr(0, 40), "image/webp").why_not,
        "t.gltf: image 0 'i': a damaged WebP picture");
}

TEST(GltfImages, LimitsTheSizeOfWebP)
{
    if (!FIRSTHIT_WITH_WEBP) GTEST_SKIP() << "built without libwebp";
    // A lossless header of 16384 x 16383 pixels.
    std::string bytes = "RIFF" + little_endian(30) + "WEBPVP8L" + little_endian(18) + "\x2f" +
                        little_endian(16383u | 16382u << 14) + std::string(13, '\0');
    EXPECT_EQ(decode(bytes, "image/webp").why_not,
        "t.gltf: image 0 'i': a picture of 16384 x 16383 is too large, at most 16384 on a side and "
        "67108864 texels are accepted");
}

TEST(GltfImages, SaysWhyThereIsNoPicture)
{
    EXPECT_EQ(decode("\xABKTX 20\xBB\r\n\x1A\n...", "image/ktx2").why_not,
        "t.gltf: image 0 'i': pictures in KTX2 are not supported");
    EXPECT_EQ(decode("sB..", "").why_not,
        "t.gltf: image 0 'i': pictures in Basis Universal are not supported");
    EXPECT_EQ(decode("GIF89a", "image/gif").why_not,
        "t.gltf: image 0 'i': not a PNG, JPEG or WebP picture");
    EXPECT_EQ(decode("\x89PNG\r\n\x1a\n", "image/png").why_not.substr(0, 50),
        "t.gltf: image 0 'i': the PNG picture is cut off or");
    const Document document = read_members(
        R"("images": [{"uri": "a.png"}, {"uri": "http://a/b.png"}, {}, {"uri": "data:image/png;base64,*"}, {"bufferView": 0}],
        "buffers": [{"byteLength": 1}], "bufferViews": [{"buffer": 0, "byteLength": 1}])");
    EXPECT_EQ(decode_image(document, 0).why_not,
        "t.gltf: image 0: 'a.png': other files are not read without a folder");
    EXPECT_EQ(decode_image(document, 1).why_not,
        "t.gltf: image 1: 'http://a/b.png': only data URIs and names of files are read");
    EXPECT_EQ(decode_image(document, 2).why_not,
        "t.gltf: image 2: it has neither a uri nor a bufferView");
    EXPECT_EQ(decode_image(document, 3).why_not, "t.gltf: image 3: its data URI is damaged");
    EXPECT_EQ(decode_image(document, 4).why_not,
        "t.gltf: image 4: its bytes are missing: its buffer has no uri");
}

TEST(GltfImages, ListsFilesAlsoMissingOnes)
{
    const TemporaryFolder folder;
    folder.write("a b.png", seed("picture.png"));
    const std::filesystem::path path = folder.write("t.gltf",
        R"({"asset": {"version": "2.0"}, "images": [{"uri": "a%20b.png"}, {"uri": "gone.png"}]})");
    const Document document = read_document(path);
    EXPECT_EQ(document.files,
        (std::vector<std::string>{path.string(), folder / "a b.png", folder / "gone.png"}));
    EXPECT_TRUE(decode_image(document, 0).picture);
    EXPECT_EQ(decode_image(document, 1).why_not, (folder / "gone.png") + ": no such file");
    EXPECT_EQ(read_image(document, 0).kind, ImageKind::kPng);
}

} // namespace
} // namespace firsthit::gltf
