// parse.h - turns words of the command line into values.
#pragma once

#include <firsthit/film.h>
#include <firsthit/render.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace firsthit::cli {

/// All of these throw UsageError that names the text and what is accepted.

/// The whole text as a finite number; a point is a point in any locale.
double parse_number(const std::string& text);

/// The whole text as an integer from low to high.
int parse_integer(const std::string& text, int low, int high);

struct Size {
    int width = 1024;
    int height = 1024;
};

/// "1024x768", each 1 to 65536.
Size parse_size(const std::string& text);

/// "x,y,z"
glm::dvec3 parse_vector(const std::string& text);

/// "A:B:N": N times from A to B inclusive (A alone where N is 1), 1 to 1,000,000 of them.
std::vector<double> parse_frames(const std::string& text);

struct AovOutput {
    Aov aov = Aov::item;
    std::string path;
};

/// "name=file"
AovOutput parse_aov(const std::string& text);

/// "none", "lazy3", "lazy5", "full3", "full5" or "exact"
Multisample parse_multisample(const std::string& text);

/// A full vertical angle in degrees, above 0 and below 180, as radians.
double parse_fov(const std::string& text);

} // namespace firsthit::cli
