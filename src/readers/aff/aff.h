// aff.h - reads AFF and NFF scenes.
//
// AFF is the format of BART (Lext, Assarsson and Möller 2000), a superset of Haines's NFF. Plain
// text: statements of a keyword and its operands, separated by any white space; `#` and `%` start
// comments.
//
//     v from x y z at x y z up x y z angle a hither h resolution w h     camera
//     l x y z [r g b]            la name x y z [r g b]                   light, light moved by a
//     track b r g b    am r g b    a start end frames                          background, ambient,
//     times f r g b Kd Ks shine T ior                                          material (NFF) fm ar
//     ag ab dr dg db sr sg sb shine T ior                          material d n        i level file
//     detail, include c bx by bz rbase ax ay az rapex        s x y z r                   open cone,
//     sphere p n (x y z)...    pp n (x y z nx ny nz)...                         polygon tt texture
//     (x y z u v)x3    ttp texture (x y z nx ny nz u v)x3     textured triangle tpa k (time (x y z
//     nx ny nz)x3)...                                 animated triangle m vertices n .. [normals n
//     ..] [texturecoords n texture ..] triangles n ..       mesh xs sx sy sz  ax ay az deg  tx ty
//     tz { .. }      x name { .. }      static, animated transform k name { transl n ..  scale n ..
//     rot n ..  visibility n .. }      track
//
// Choices where the format leaves one:
// - Names of included files are relative to the main file's folder; textures are looked for there
// and
//   in the folder TextureFiles beside it. A texture that cannot be read is a warning, once a file,
//   and leaves a plain colour. Texture coordinates stay as they are, and pictures are turned upside
//   down, as BART has v = 0 at the first row of a file and a Texture at the last.
// - The current material is one for all files and is not restored by `}`. Before the first `f` or
//   `fm` it is Phong{}. An `f` has no ambient colour. Colours are linear.
// - Lights are in world space wherever they stand.
// - A polygon, triangle or mesh without normals is flat. A normal of length zero counts as none.
// - A sphere of n segments has n (n - 2) triangles: 960 at 32. A cone has 2 n, or n where one
// radius
//   is 0, or none, with a warning, where both are. Negative radii turn a shape inside out.
// - Where several tracks have one name, the last one counts. A node without a track stands still.
// - `hither` is read and not used. `resolution` is Scene::picture_size.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// How a scene gets at the files that it names. Both throw FileError where there is none.
struct AffFiles {
    std::function<std::string(const std::string& name)> include_text;
    std::function<Texture(const std::string& name)> texture;
};

/// The vertices of the scene that are vertices of one mesh statement, in its order and without
/// those that no triangle uses. Corners that differ only in normal or texture coordinates come
/// after them.
struct AffMeshRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Reads a scene from a file.
///
/// limits  100,000 followed includes; counts up to 4,294,967,294; nesting is not limited
/// throws  FileError: unreadable or malformed, recursive includes, braces that do not match
///         SceneError: an index out of range, a number that is not finite or does not fit a float
///         ArgumentError: a number of segments outside [4, 4096]
///         Each of the first two names the file and the line.
Scene read_aff(const std::filesystem::path& path, const LoadSettings& settings);

/// Reads a scene from text, without Scene::files. `name` is the main file's, for errors and to know
/// recursion.
///
/// meshes  where not null: gets the vertices of each mesh statement in file order
/// throws  as read_aff
Scene parse_aff(const std::string& name, std::string_view text, const AffFiles& files,
    const LoadSettings& settings, std::vector<AffMeshRange>* meshes = nullptr);

/// How read_aff finds the files that the scene at this path names.
///
/// opened  where not null: gets the path of each file that is read; it must outlive what is returned
AffFiles aff_files_beside(
    const std::filesystem::path& path, std::vector<std::string>* opened = nullptr);

} // namespace firsthit
