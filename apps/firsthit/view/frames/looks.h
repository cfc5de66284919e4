// looks.h - what each way of looking needs of a frame, and the pixels that it makes of it.
#pragma once

#include "view/frames/view_state.h"

#include <firsthit/film.h>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Asks the settings for the planes of a look, and for colours or none.
/// lights  of the scene
/// returns what stands in the way of the look, or nothing
std::string ask_for_planes(Look look, std::size_t lights, Settings& settings);

/// How a film becomes pixels.
struct Painting {
    Look look = Look::color;
    int light = 0;
    Tone tone{};
    bool dither = true;
    bool exact = false;              // every pixel is the one of a .png; else within a code of it
    std::int32_t selected = -1;      // an instance whose border is drawn
    const Film* reference = nullptr; // the exact film of Look::difference and wrong
};

/// The pixels of a film, (height, width, 4) sRGB and opaque.
void paint(const Film& film, const Painting& painting, std::vector<std::uint8_t>& rgba);

} // namespace firsthit::cli::view
