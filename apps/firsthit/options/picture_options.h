// picture_options.h - what stands behind the scene, and how pictures are written.
#pragma once

#include <firsthit/picture.h>
#include <firsthit/scene.h>
#include <firsthit/settings.h>

#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// What stands where nothing is seen. Nothing given: what the scene has.
struct Backdrop {
    bool transparent = false;
    std::optional<glm::vec3> color;
    std::optional<Gradient> gradient;

    /// Whether the picture is made with coverage.
    bool needs_alpha() const { return transparent || gradient; }
};

struct PictureChoices {
    Backdrop backdrop;
    bool dither = true;
    std::optional<int> quality;
    std::string
        format; // of standard output, an ending as ".png"; empty: .png of pictures, .npy of planes
};

/// "transparent", "r,g,b" or "r,g,b:r,g,b" (top and bottom), linear. throws  UsageError
Backdrop parse_backdrop(const std::string& text);

/// --background, --dither, --quality, --output-format
void add_picture_options(CLI::App& app, PictureChoices& options);

/// How a picture is written to a path, "-" for standard output.
PictureOptions picture_options(
    const PictureChoices& options, const Tone& tone, const std::string& path);

/// The format of a plane for write_plane: an ending for standard output, else nothing.
std::string plane_format(const PictureChoices& options, const std::string& path);

/// throws  UsageError: an ending, transparency in a .jpg, --quality of a format that has none
///         FileError: the folder
void check_picture(const PictureChoices& options, const std::string& path);

/// Takes the scene's background away, or replaces it.
void apply(const Backdrop& backdrop, Scene& scene);

} // namespace firsthit::cli
