// aff_errors_test.cpp - what is wrong with a scene is said with file and line.
#include "readers/aff/aff_text.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace firsthit {
namespace {

enum class Kind { file, scene };

struct Bad {
    const char* name;
    std::string text;
    Kind kind;
    std::string message; // the whole of it
};

std::ostream& operator<<(std::ostream& out, const Bad& bad)
{
    return out << bad.name;
}

class BadAff : public testing::TestWithParam<Bad> {};

template <class ErrorKind>
void expect_error(const Bad& bad)
{
    const std::map<std::string, std::string> files = {{"self.aff", "\ni 0 ./self.aff"},
        {"ping.aff", "i 0 pong.aff"}, {"pong.aff", "l 0 0 0\n\ni 0 ping.aff"},
        {"main-again.aff", "i 0 main.aff"}, {"open.aff", "x a {"}, {"close.aff", "}"},
        {"bad.aff", "\n\nfoo"}};
    try {
        scene_of(bad.text, files);
        ADD_FAILURE() << "no error";
    } catch (const ErrorKind& error) {
        EXPECT_EQ(error.what(), bad.message);
    }
}

TEST_P(BadAff, IsRefusedWithItsPlace)
{
    if (GetParam().kind == Kind::file)
        expect_error<FileError>(GetParam());
    else
        expect_error<SceneError>(GetParam());
}

const std::string kView = "v from 0 0 1 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 4 4";
const std::string kMesh = "m vertices 3 0 0 0 1 0 0 0 1 0\n";

const Bad kBad[] = {
    // The text itself.
    {"Empty", "", Kind::file, "main.aff:1: the file has no statement"},
    {"OnlyComments", "# a\n% b\n", Kind::file, "main.aff:1: the file has no statement"},
    {"Garbage",
        "\x7f"
        "ELF\x02\x01",
        Kind::file, "main.aff:1: there is no statement '\\x7fELF\\x02\\x01'"},
    {"NotUtf8", kTriangle + "\xff\xfe", Kind::file,
        "main.aff:2: there is no statement '\\xff\\xfe'"},
    {"UnknownStatement", "l 0 0 0\nma 1", Kind::file, "main.aff:2: there is no statement 'ma'"},
    {"StrayNumber", "l 0 0 0 1 1 1 1", Kind::file, "main.aff:1: there is no statement '1'"},
    {"StrayOpenBrace", "{", Kind::file, "main.aff:1: there is no statement '{'"},
    {"LongToken", std::string(100000, 'q'), Kind::file,
        "main.aff:1: there is no statement '" + std::string(40, 'q') + "...'"},

    // Numbers.
    {"NoNumber", "l 0 zero 0", Kind::file,
        "main.aff:1: the light's place should be a number, not 'zero'"},
    {"NotANumber", "l\n0\nnan 0", Kind::scene,
        "main.aff:3: the light's place should be a finite number, not 'nan'"},
    {"Infinite", "s 0 inf 0 1", Kind::scene,
        "main.aff:1: the sphere's middle should be a finite number, not 'inf'"},
    {"TooLargeForADouble", "s 0 0 0 1e999", Kind::scene,
        "main.aff:1: the sphere's radius should be a finite number, not '1e999'"},
    {"TooLargeForAFloat", "s 0 0 0 1e39", Kind::scene,
        "main.aff:1: the sphere's radius is too large: it must lie within +-3.4e38"},
    {"ShapeBeyondFloats", "s 3e38 0 0 3e38", Kind::scene,
        "main.aff:1: the shape reaches beyond +-3.4e38"},

    // Ends too early.
    {"EndsInALight", "l 0 0", Kind::file,
        "main.aff:1: the file ends where the light's place should stand"},
    {"EndsInAView", "v from 0 0 0\nat 0 0 1\nup", Kind::file,
        "main.aff:3: the file ends where the camera's up should stand"},
    {"EndsBeforeAWord", "v from 0 0 0", Kind::file,
        "main.aff:1: the file ends where 'at' of statement 'v' should stand"},
    {"EndsInAMesh", kMesh, Kind::file,
        "main.aff:2: the file ends where 'triangles' of statement 'm' should stand"},
    {"EndsInATrack", "k a {", Kind::file, "main.aff:1: the file ends inside the track 'a'"},
    {"EndsInANode", "x a {\n\n" + kTriangle, Kind::file,
        "main.aff:4: the file ends before the '{' of line 1 is closed"},
    {"BraceInOperands", "l 0 } 0", Kind::file,
        "main.aff:1: found '}' where the light's place should stand"},

    // Counts.
    {"FourBillionCorners", "p 4294967295 0 0 0", Kind::file,
        "main.aff:1: the file ends where a corner should stand"},
    {"FourBillionVertices", "m vertices 4000000000 0 0 0", Kind::file,
        "main.aff:1: the file ends where a vertex should stand"},
    {"FourBillionNormals", kMesh + "normals 4000000000", Kind::file,
        "main.aff:2: the file ends where a normal should stand"},
    {"FourBillionTextureCoordinates", kMesh + "texturecoords 4000000000 red.ppm", Kind::file,
        "main.aff:2: the file ends where a texture coordinate should stand"},
    {"FourBillionTriangles", kMesh + "triangles 4000000000 0 1 2", Kind::file,
        "main.aff:2: the file ends where vertex should stand"},
    {"FourBillionKeys", "k a {transl 4000000000 0 0 0 0 0 0 0", Kind::file,
        "main.aff:1: the file ends where a key's time should stand"},
    {"FourBillionSteps", "k a {visibility 4000000000 0 0", Kind::file,
        "main.aff:1: the file ends where a key's time should stand"},
    {"FourBillionShapes", "tpa 4000000000", Kind::file,
        "main.aff:1: the file ends where a key's time should stand"},
    {"CountTooLarge", "p 4294967296", Kind::file,
        "main.aff:1: the number of corners should lie between 0 and 4294967295, not be 4294967296"},
    {"CountNegative", "p -1", Kind::file,
        "main.aff:1: the number of corners should lie between 0 and 4294967295, not be -1"},
    {"CountHugeWithDigits", "p 99999999999999999999999", Kind::file,
        "main.aff:1: the number of corners should be a whole number, not "
        "'99999999999999999999999'"},
    {"CountBroken", "p 3.5", Kind::file,
        "main.aff:1: the number of corners should be a whole number, not '3.5'"},
    {"NoShapes", "tpa 0", Kind::scene,
        "main.aff:1: an animated triangle should have 1 key or more"},
    {"ThreeKeys", "k a {\nrot 3 ", Kind::scene,
        "main.aff:2: the block 'rot' should have 4 keys or more, not 3"},

    // Meshes.
    {"VertexOutOfRange", kMesh + "triangles 1\n0 1 3", Kind::scene,
        "main.aff:3: triangle 0: vertex 3 is out of range (3 exist)"},
    {"VertexNegative", kMesh + "triangles 1\n0 -1 2", Kind::file,
        "main.aff:3: vertex should lie between 0 and 4294967295, not be -1"},
    {"NormalOutOfRange", kMesh + "normals 1 0 0 1 triangles 1 0 1 2 0 0 1", Kind::scene,
        "main.aff:2: triangle 0: normal 1 is out of range (1 exist)"},
    {"TextureCoordinateOutOfRange",
        kMesh + "texturecoords 1 red.ppm 0 0 triangles 2 0 1 2 0 0 0 0 1 2 0 0 7", Kind::scene,
        "main.aff:2: triangle 1: texture coordinate 7 is out of range (1 exist)"},

    // Meaning.
    {"NoAngle", "v from 0 0 1 at 0 0 0 up 0 1 0 angle 180", Kind::scene,
        "main.aff:1: the camera's angle should lie between 0 and 180 degrees, not be 180.000000"},
    {"NowhereToLook", "\nv from 1 1 1 at 1 1 1 up 0 1 0 angle 45 hither 1 resolution 4 4",
        Kind::scene, "main.aff:2: the camera's 'from' and 'at' are the same point"},
    {"UpWhereItLooks", "v from 0 1 0 at 0 0 0 up 0 2 0 angle 45 hither 1 resolution 4 4",
        Kind::scene, "main.aff:1: the camera's 'up' is zero or points where it looks"},
    {"BackwardsAnimation", "a 5 4 10", Kind::scene,
        "main.aff:1: the animation ends before it starts"},
    {"NoFrames", "a 0 1 0", Kind::scene,
        "main.aff:1: the number of frames should lie between 1 and 1000000000, not be 0"},
    {"BrightMaterial", "f 3e38 0 0 3e38 0 0 0 1", Kind::scene,
        "main.aff:1: the material's Kd times its colour is too large"},
    {"ConeWithoutHeight", "c 1 1 1 1 1 1 1 2", Kind::scene,
        "main.aff:1: the cone's base and apex are the same point"},
    {"ConeOfTwoMinds", "c 0 0 0 1 0 1 0 -1", Kind::scene,
        "main.aff:1: the cone's radii should both be positive or both negative"},
    {"ShapesOutOfOrder",
        "tpa 2 1 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0 1\n0 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0 1",
        Kind::scene, "main.aff:2: the keys of an animated triangle should be in order of time"},
    {"TransformWithoutAxis", "xs 1 1 1 0 0 0 5 0 0 0 {", Kind::scene,
        "main.aff:1: the transform turns about an axis of length 0"},
    {"KeyWithoutAxis", "k a{rot 4 0 0 0 0 5", Kind::scene,
        "main.aff:1: a key turns about an axis of length 0"},
    {"HalfVisible", "k a{visibility 1 0 2", Kind::scene,
        "main.aff:1: a key's visibility should be 0 or 1, not 2"},
    {"UnknownBlock", "k a{\nspin 4}", Kind::file,
        "main.aff:2: found 'spin' where transl, scale, rot, visibility or '}' of a track should "
        "stand"},
    {"TwoBlocks", "k a{scale 4 0 1 1 1 0 0 0 1 1 1 1 0 0 0 2 1 1 1 0 0 0 3 1 1 1 0 0 0\nscale 4}",
        Kind::file, "main.aff:2: a second block 'scale' in one track"},
    {"TwoVisibilities", "k a{visibility 1 0 1\nvisibility 1 0 1}", Kind::file,
        "main.aff:2: a second block 'visibility' in one track"},

    // Nesting.
    {"CloseWithoutOpen", "x a {}\n}", Kind::file, "main.aff:2: a '}' without its '{'"},
    {"CloseInAnInclude", "x a {\ni 0 close.aff\n}", Kind::file,
        "close.aff:1: a '}' without its '{'"},
    {"OpenInAnInclude", "i 0 open.aff\n}", Kind::file,
        "open.aff:1: the file ends before the '{' of line 1 is closed"},
    {"NodeWithoutBrace", "x a l 0 0 0", Kind::file,
        "main.aff:1: found 'l' where '{' of statement 'x' should stand"},
    {"NodeWithoutName", "x {}", Kind::file,
        "main.aff:1: found '{' where the transform's name should stand"},
    {"MissingInclude", "l 0 0 0\ni 0 gone.aff", Kind::file,
        "main.aff:2: cannot include 'gone.aff': gone.aff: no such file"},
    {"ErrorInAnInclude", "i 0 bad.aff", Kind::file, "bad.aff:3: there is no statement 'foo'"},
    {"IncludesItself", "i 0 self.aff", Kind::file,
        "self.aff:2: recursive include: self.aff -> self.aff"},
    {"IncludesInACircle", "i 0 ping.aff", Kind::file,
        "pong.aff:3: recursive include: ping.aff -> pong.aff -> ping.aff"},
    {"IncludesTheMainFile", "i 0 main-again.aff", Kind::file,
        "main-again.aff:1: recursive include: main.aff -> main-again.aff -> main.aff"},
};

INSTANTIATE_TEST_SUITE_P(Aff, BadAff, testing::ValuesIn(kBad),
    [](const testing::TestParamInfo<Bad>& bad) { return std::string(bad.param.name); });

TEST(BadAffFiles, AreRefusedWhenTheyDoubleWithoutEnd)
{
    // Each file includes the next one twice: 2^40 files.
    std::map<std::string, std::string> files;
    for (int k = 0; k < 40; ++k) {
        const std::string next = "f" + std::to_string(k + 1);
        files["f" + std::to_string(k)] = "i 0 " + next + " i 0 " + next;
    }
    files["f40"] = "l 0 0 0";
    try {
        scene_of("i 0 f0", files);
        ADD_FAILURE() << "no error";
    } catch (const FileError& error) {
        EXPECT_NE(
            std::string(error.what()).find(": more than 100000 included files"), std::string::npos);
    }
}

TEST(BadAffFiles, NameLongCirclesShort)
{
    std::map<std::string, std::string> files;
    for (int k = 0; k < 1000; ++k)
        files["f" + std::to_string(k)] = "i 0 f" + std::to_string((k + 1) % 1000);
    try {
        scene_of("i 0 f0", files);
        ADD_FAILURE() << "no error";
    } catch (const FileError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("f999:1: recursive include: f0 -> f1 -> ")) << message;
        EXPECT_TRUE(message.ends_with(" -> f999 -> f0")) << message;
        EXPECT_LT(message.size(), 300u);
    }
}

TEST(BadAffFiles, AreRefusedWhereverTheyAreCut)
{
    // Every prefix of a scene either reads or is refused with its place.
    const std::string text = kView + "\nam 1 1 1 a 0 1 2 l 1 1 1\nfm 1 1 1 1 1 1 1 1 1 5 0 1\n" +
                             kMesh +
                             "normals 1 0 0 1\ntriangles 1 0 1 2 0 0 0\nx a{xs 1 1 1 0 1 0 9 1 2 3"
                             "{tpa 1 0 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1}}\n"
                             "k a{transl 4 0 0 0 0 0 0 0 1 1 1 1 0 0 0 2 0 0 0 0 0 0 "
                             "3 1 1 1 0 0 0}s 0 0 0 1 c 0 0 0 1 0 1 0 0";
    ASSERT_NO_THROW(scene_of(text));
    for (std::size_t size = 0; size < text.size(); ++size) {
        try {
            scene_of(text.substr(0, size));
        } catch (const Error& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("main.aff:")) << error.what();
        }
    }
}

} // namespace
} // namespace firsthit
