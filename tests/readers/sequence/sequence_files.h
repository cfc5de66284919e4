// sequence_files.h - small numbered files for tests of sequences.
#pragma once

#include "temporary_folder.h"

#include <fmt/format.h>

#include <string>

namespace firsthit::test {

/// An OBJ of a unit cube of quads, moved along x and stretched along y.
inline std::string cube_obj(double x, double height = 1)
{
    std::string obj;
    for (const char* corner : {"000", "100", "110", "010", "001", "101", "111", "011"})
        obj += fmt::format(
            "v {} {} {}\n", x + (corner[0] - '0'), height * (corner[1] - '0'), corner[2] - '0');
    return obj + "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";
}

/// An OBJ of one triangle in the plane z = x.
inline std::string triangle_obj(double x)
{
    return fmt::format("v 0 0 {0}\nv 1 0 {0}\nv 0 1 {0}\nf 1 2 3\n", x);
}

/// frame_0001.obj and so on: cubes that move by 1 along x from frame to frame.
inline std::string write_cubes(const TemporaryFolder& folder, int count)
{
    for (int k = 1; k <= count; ++k) folder.write(fmt::format("frame_{:04}.obj", k), cube_obj(k));
    return folder / "frame_%04d.obj";
}

} // namespace firsthit::test
