// view_state.h - what the one who looks has chosen: all that a picture of the window depends on but the camera.
#pragma once

#include <firsthit/film.h>
#include <firsthit/settings.h>

#include <cstdint>

namespace firsthit::cli::view {

/// Ways of looking at a frame.
enum class Look {
    color,      // the picture
    items,      // each triangle in a colour of its own
    instances,  // each instance in a colour of its own
    materials,  // likewise
    depth,      // near is bright, far is dark
    normals,    // x, y, z in [-1, 1] as red, green, blue
    uv,         // texture coordinates, wrapped, as red and green
    light,      // which share of one light arrives
    light_view, // depth as one light sees it, which is what its shadow map holds
    difference, // eight times the difference from the exact picture
    wrong,      // in red the pixels whose triangle is not the exact one
};

/// The light from all around: what the scene and the options say, or another.
enum class EnvironmentChoice { given, none, studio };

/// All switches. `settings` are those of the picture at rest: while something moves, less is made.
struct ViewState {
    Settings settings;
    Tone tone;
    bool dither = true;

    Look look = Look::color;
    int light = 0; // of Look::light and light_view, counted from 0

    bool hold_rate = true; // while something moves, leave out what is dear
    double rate = 60;      // frames a second to hold

    std::int32_t clip = 0; // or PoseSettings::kRest
    double time_s = 0;
    bool playing = false;
    bool loop = true;
    double speed = 1;       // seconds of the clip in a second
    bool turntable = false; // the camera goes round the scene
    int camera = 0;         // of Scene::cameras, where the camera was not moved
    bool studio = false;    // the scene is lit by the studio
    EnvironmentChoice environment = EnvironmentChoice::given;
    std::int32_t selected = -1; // an instance, or -1

    bool panel = true;  // with the switches
    bool bars = true;   // times of stages
    bool corner = true; // the line that says what is shown
    bool help = false;  // the page of keys
    bool hover = true;  // what is under the pointer
};

} // namespace firsthit::cli::view
