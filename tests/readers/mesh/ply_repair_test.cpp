// ply_repair_test.cpp - PLY texts with odd words and headers are shown, and every fault is told of once.
#include "readers/mesh/mesh_text.h"
#include "readers/scene_parts.h"

#include <string>

namespace firsthit::test {
namespace {

const std::string kFour = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(PlyRepair, TakesEveryWordForNoNumber)
{
    for (const char* word :
        {"nan", "-nan(ind)", "1.#QNAN", "-1.#IND", "inf", "-Infinity", "1e39"}) {
        SCOPED_TRACE(word);
        const Scene scene = read(
            ply_header("ascii", "5", "2") + kFour + word + " 0 0\n4 0 1 2 3\n3 0 1 4\n", ".ply");
        EXPECT_EQ(scene.triangle_count(), 2u);
        expect_in(warning_of(scene),
            "triangles with a corner that is no finite float are left out (first at triangle 2)");
    }
    EXPECT_EQ(error_of<FileError>(ply_header("ascii", "1", "1") + "0 x 0\n3 0 0 0\n", ".ply"),
        "m.ply:11: a value is 'x', a number is needed");
}

TEST(PlyRepair, TakesUnknownTypesOfATextForNumbers)
{
    const Scene scene =
        read(ply_header("ascii", "4", "1", "property string name\nproperty half nx\n") +
                 "0 0 0 a 1\n1 0 0 b 1\n1 1 0 c 1\n0 1 0 d 1\n4 0 1 2 3\n",
            ".ply");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(warning_of(scene),
        "m.ply: values of unknown types are taken for numbers (first at line 8, 2 times)");
}

TEST(PlyRepair, TellsOfElementsOfOneName)
{
    std::string header = ply_header("ascii", "4", "1");
    header.insert(
        header.find("end_header"), "element face 1\nproperty list uchar int vertex_indices\n");
    const Scene scene = read(header + kFour + "4 0 1 2 3\n3 0 1 2\n", ".ply");
    EXPECT_EQ(scene.triangle_count(), 2u);
    EXPECT_EQ(warning_of(scene), "m.ply: of elements of the same name the first is used");
}

TEST(PlyRepair, TakesTheFirstWordInCapitals)
{
    std::string text = ply_header("ascii", "4", "1") + kFour + "4 0 1 2 3\n";
    text.replace(0, 3, "PLY");
    EXPECT_EQ(read(text, ".ply").triangle_count(), 2u);
}

} // namespace
} // namespace firsthit::test
