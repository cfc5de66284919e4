// aff_files_test.cpp - AFF scenes and their textures on the disk.
#include "base/srgb.h"

#include "message_of.h"
#include "readers/aff/aff_text.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace firsthit {
namespace {

const std::string kTextured = "tt a.ppm 0 0 0 0 0 1 0 0 1 0 0 1 0 0 1\n";
const std::string kPicture = std::string("P6 1 1 255\n") + "\x10\x20\x30";

void expect_file_error(const std::filesystem::path& path, const std::string& end)
{
    EXPECT_EQ(message_of<FileError>([&] { read_aff(path, {}); }), path.string() + end);
}

TEST(AffFiles, AreIncludedRelativeToTheMainFile)
{
    const TemporaryFolder folder;
    const auto main = folder.write("scene/main.aff", "i 0 parts/a.aff");
    folder.write("scene/parts/a.aff", "i 0 parts/b.aff");
    folder.write("scene/parts/b.aff", kTriangle);
    const Scene scene = read_aff(main, {});
    EXPECT_EQ(scene.triangle_count(), 1u);
    EXPECT_EQ(scene.name, main.string());
}

TEST(AffFiles, FindTexturesBesideTheSceneOrInTheFolderOfTextures)
{
    const TemporaryFolder folder;
    const auto main = folder.write("aff/main.aff", kTextured + "tt b.ppm" + kTextured.substr(8));
    folder.write("aff/a.ppm", kPicture);
    folder.write("TextureFiles/b.ppm", kPicture);
    const Scene scene = read_aff(main, {});
    EXPECT_TRUE(scene.warnings.empty());
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[1].name(), "b.ppm");
    EXPECT_NEAR(scene.textures[1].color(0, 0, 0).b, linear_from_srgb()[0x30], 2e-5);
}

TEST(AffFiles, WarnOfMissingAndDamagedTextures)
{
    const TemporaryFolder folder;
    const auto main = folder.write("main.aff", kTextured + "tt bad.ppm" + kTextured.substr(8));
    folder.write("bad.ppm", "P6 100 100 255\nshort");
    const Scene scene = read_aff(main, {});
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_EQ(scene.warnings[0], main.string() +
                                     ":1: no texture 'a.ppm', a plain colour instead: " +
                                     (folder.path() / "a.ppm").string() + ": no such file");
    EXPECT_NE(scene.warnings[1].find("5 bytes of pixels instead of 30000"), std::string::npos);
}

TEST(AffFiles, ThatAreMissingAreNamed)
{
    const TemporaryFolder folder;
    expect_file_error(folder.path() / "gone.aff", ": no such file");
    const auto main = folder.write("main.aff", "\n i 0 gone.aff");
    expect_file_error(main, ":2: cannot include 'gone.aff': " +
                                (folder.path() / "gone.aff").string() + ": no such file");
}

TEST(AffFiles, MustBeRegular)
{
    const TemporaryFolder folder;
    expect_file_error(folder.path(), ": not a regular file");
    const auto main = folder.write("main.aff", "i 0 /dev/zero");
    expect_file_error(main, ":1: cannot include '/dev/zero': /dev/zero: not a regular file");
}

TEST(AffFiles, MayBeIncludedThroughALinkToThemselvesWithoutAnEnd)
{
    const TemporaryFolder folder;
    const auto main = folder.write("main.aff", "i 0 sub/main.aff");
    std::filesystem::create_directory_symlink(".", folder.path() / "sub");
    // The names differ, so no circle is seen before the second round.
    EXPECT_THROW(read_aff(main, {}), FileError);
}

} // namespace
} // namespace firsthit
