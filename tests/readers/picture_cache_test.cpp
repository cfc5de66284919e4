// picture_cache_test.cpp - frames of a sequence with the same textures decode them once.
#include "readers/image/image_file.h"
#include "readers/image/picture_cache.h"
#include "readers/sequence/sequence_files.h"
#include "temporary_folder.h"

#include <firsthit/error.h>
#include <firsthit/sequence.h>

#include <gtest/gtest.h>

#include <string>

namespace firsthit {
namespace {

/// A picture of one pixel, of that grey.
std::string pixel(char grey)
{
    return std::string("P6 1 1 255\n") + grey + grey + grey;
}

Picture decode(const std::string& bytes, const std::string& name = "a.ppm")
{
    return decode_picture(name, std::span(bytes.data(), bytes.size()));
}

TEST(PictureCache, KeepsAPictureByItsBytes)
{
    PictureCache cache;
    EXPECT_EQ(PictureCache::current(), nullptr);
    const PictureCache::Use use(cache);
    EXPECT_EQ(PictureCache::current(), &cache);
    EXPECT_EQ(decode(pixel('a')).pixel.at(0), 0xFF616161u);
    EXPECT_EQ(decode(pixel('a'), "another name").pixel.at(0), 0xFF616161u);
    EXPECT_EQ(cache.size(), 1u);
    EXPECT_EQ(decode(pixel('b')).pixel.at(0), 0xFF626262u);
    EXPECT_EQ(cache.size(), 2u);
    const std::string known = pixel('a'), other = pixel('c');
    ASSERT_NE(cache.find(known), nullptr);
    EXPECT_EQ(cache.find(known), cache.find(known)); // the same one
    EXPECT_EQ(cache.find(other), nullptr);
}

TEST(PictureCache, KeepsTexturesByTheirBytesAndEncoding)
{
    PictureCache cache;
    const PictureCache::Use use(cache);
    const std::string bytes = pixel('a');
    const Texture srgb = decode_texture("a.ppm", bytes);
    const Texture linear = decode_texture("b.ppm", bytes, Encoding::linear);
    EXPECT_NE(srgb.color(0, 0, 0), linear.color(0, 0, 0));
    for (const Encoding encoding : {Encoding::srgb, Encoding::linear}) {
        ASSERT_NE(cache.find_texture(bytes, encoding), nullptr);
        const Texture again = decode_texture("other", bytes, encoding);
        EXPECT_EQ(again.name(), "other");
        EXPECT_EQ(
            again.color(0, 0, 0), (encoding == Encoding::srgb ? srgb : linear).color(0, 0, 0));
    }
    EXPECT_EQ(cache.find(bytes), nullptr); // nobody asked for the picture
    EXPECT_EQ(cache.size(), 1u);
}

TEST(PictureCache, DoesNotKeepWhatIsNoPicture)
{
    PictureCache cache;
    const PictureCache::Use use(cache);
    for (int round = 0; round < 2; ++round) EXPECT_THROW(decode("P6 1 1 255\n"), FileError);
    EXPECT_EQ(cache.size(), 0u);
}

TEST(PictureCache, LetsPicturesGoThatTheLastScenesDidNotUse)
{
    PictureCache cache;
    for (std::size_t scene = 0; scene < 20; ++scene) {
        const PictureCache::Use use(cache);
        decode(pixel('a'));                            // of every scene
        decode(pixel(static_cast<char>('b' + scene))); // of this one alone
        EXPECT_LE(cache.size(), PictureCache::kKept + 2);
    }
    EXPECT_EQ(PictureCache::current(), nullptr);
    const std::string always = pixel('a'), once = pixel('b');
    EXPECT_NE(cache.find(always), nullptr);
    EXPECT_EQ(cache.find(once), nullptr);
}

TEST(PictureCache, AFrameWhoseTextureHasChangedShowsTheNewOne)
{
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl a\nmap_Kd t.ppm\n");
    folder.write("t.ppm", pixel('\0'));
    for (int k = 0; k < 3; ++k)
        folder.write(fmt::format("{}.obj", k),
            "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    SceneSequence sequence(folder / "%d.obj", {.fps = 1});
    EXPECT_EQ(sequence.frame(0)->textures.at(0).color(0, 0, 0), glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(sequence.frame(1)->textures.at(0).color(0, 0, 0), glm::vec4(0, 0, 0, 1));
    folder.write("t.ppm", pixel('\xFF'));
    EXPECT_EQ(sequence.frame(2)->textures.at(0).color(0, 0, 0), glm::vec4(1));
}

} // namespace
} // namespace firsthit
