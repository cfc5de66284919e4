// basics.cpp - what most people need of each command: the first screen of its help.
#include "help/basics.h"

#include <array>

namespace firsthit::cli {
namespace {

constexpr BasicOption kRender[] = {
    {"SCENE", "a file (glTF, OBJ, PLY, STL, FBX, ...) or builtin:torus|robots|room|wave"},
    {"--output", "a picture (.png .jpg .webp .exr) or a film (.mp4 .webm .gif)"},
    {"--size", "pixels; default 1024x1024"},
    {"--view", "iso, front, back, left, right, top or bottom"},
    {"--up-axis", "what is up in the file: x, y, z, -x, -y or -z"},
    {"--zoom", "how many times as large things are"},
    {"--eye", "where the eye is"},
    {"--at", "a point that the eye looks at"},
    {"--fov", "full vertical angle of the picture"},
    {"--intrinsics", "a calibrated lens in pixels: fx,fy,cx,cy"},
    {"--aa", "up to N x N rays at edges; default 4; 1: none"},
    {"--background", "transparent, a colour, or two from top to bottom"},
    {"--sky", "light from N directions of the sky; 0: none"},
    {"--draft", "a first look, without sky and smooth edges"},
    {"--light", "lights in the place of the scene's own, as point:0,5,2"},
    {"--shadows", "exact (the default), map, or none"},
    {"--time", "seconds of the animation; default its begin"},
    {"--frames", "times A:B:N; clip, the whole animation; numbers 0-99"},
    {"--turntable", "N frames of one turn around the scene"},
    {"--fps", "frames a second of a film; default as fast as the scene"},
    {"--resume", "leave frames out whose files are there"},
    {"--aov", "a plane: item, instance, depth, normal, ... (.npy, .exr)"},
    {"--exr", "one .exr file of the colours and all planes"},
    {"--manifest", "what ids of planes stand for, as JSON"},
    {"--dry-run", "say what would be rendered"},
    {"--stats", "print where the time went"},
    {"--quiet", "no warnings, no bar of progress"},
    {"--verbose", "say what is done"},
};

constexpr BasicOption kView[] = {
    {"SCENE", "a file, numbered files as f/%04d.obj, or builtin:torus|robots|room|wave"},
    {"--size", "pixels of the window; default 1280x720"},
    {"--engine", "cpu (the default, exact), hybrid, gpu or auto"},
    {"--shadows", "exact (the default), map, or none"},
    {"--rate", "frames a second to hold while something moves; default 60"},
    {"--fps-limit", "show at most so many frames a second"},
    {"--time", "seconds of the animation; default its begin"},
    {"--view", "iso, front, back, left, right, top or bottom"},
    {"--up-axis", "what is up in the file: x, y, z, -x, -y or -z"},
    {"--serve", "show it in a page for a browser, without a display"},
    {"--script", "play the actions of a file, as a test does"},
    {"--screenshot", "a picture of the window at the script's end"},
    {"--no-window", "play the script without a window or display"},
    {"--measure", "at the end print frames a second, and times from input"},
};

constexpr BasicOption kInfo[] = {
    {"SCENE", "a file, numbered files as f/%04d.obj, or builtin:torus|robots|room|wave"},
    {"--json", "all of it as one JSON object"},
    {"--fps", "of numbered files: frames a second; default 24"},
    {"--scene", "of a glTF file with several scenes: which"},
    {"--clip", "the animation; default the first"},
    {"--strict", "warnings about the file are errors"},
};

constexpr BasicOption kMask[] = {
    {"SCENE", "a file, or builtin:torus|robots|room|wave"},
    {"--output", "the JSON file; - is standard output"},
    {"--by", "what gets a mask: instance (the default), node or material"},
    {"--picture", "the name of the picture that the file tells"},
    {"--counts", "masks as compressed text (the default), or as lists"},
    {"--no-visibility", "leave out which share of each object is seen"},
    {"--size", "pixels; default 1024x1024"},
    {"--view", "iso, front, back, left, right, top or bottom"},
    {"--eye", "where the eye is"},
    {"--at", "a point that the eye looks at"},
    {"--fov", "full vertical angle of the picture"},
    {"--time", "seconds of the animation; default its begin"},
    {"--frames", "times A:B:N; clip, the whole animation; numbers 0-99"},
    {"--turntable", "N pictures of one turn around the scene"},
};

constexpr BasicOption kVisible[] = {
    {"SCENE", "a file, or builtin:torus|robots|room|wave"},
    {"--output", "a .csv, .json or .npy file; default standard output"},
    {"--output-format", "csv, json or npy, whatever the file is called"},
    {"--size", "pixels; default 1024x1024"},
    {"--view", "iso, front, back, left, right, top or bottom"},
    {"--eye", "where the eye is"},
    {"--at", "a point that the eye looks at"},
    {"--time", "seconds of the animation; default its begin"},
    {"--frames", "times A:B:N; clip, the whole animation; numbers 0-99"},
    {"--turntable", "N pictures of one turn around the scene"},
};

constexpr BasicOption kCompare[] = {
    {"SCENE", "a file, or builtin:torus|robots|room|wave"},
    {"--against", "brute, embree or cpu: who says what is right"},
    {"--engine", "hybrid or gpu: the engine that is held against cpu"},
    {"--shadows", "exact: compare shadows too"},
    {"--size", "pixels; default 1024x1024"},
    {"--time", "seconds of the animation; default its begin"},
    {"--frames", "N times from A to B"},
    {"--json", "the counts as one JSON object"},
};

constexpr BasicOption kCast[] = {
    {"SCENE", "a file, or builtin:torus|robots|wave"},
    {"--rays", "the rays, (N, 6): origins and directions"},
    {"--origins", "origins, (N, 3), with --directions in the place of --rays"},
    {"--directions", "directions, (N, 3)"},
    {"--output", "what the nearest hits are: t, triangle, uv, normal ..."},
    {"--any", "only whether a ray hits anything"},
    {"--count", "only how many triangles it hits"},
    {"--all", "all hits of each ray in order"},
    {"--skip", "a triangle that each ray does not hit"},
    {"--tmax", "hits farther than this do not count"},
    {"--time", "seconds of the animation; default its begin"},
    {"--stats", "counts and times as a table"},
};

constexpr BasicOption kOcclusion[] = {
    {"SCENE", "a file, or builtin:torus|robots|room|wave"},
    {"--points", "the points, (N, 3)"},
    {"--output", "the answers: 1 occluded, 0 not"},
    {"--direction", "parallel light; the way that it goes; may be repeated"},
    {"--directions", "a file of directions, (L, 3)"},
    {"--light", "a light, or an eye, at a place; may be repeated"},
    {"--sun", "the sun over a place: LAT,LON,FROM,TO,STEP"},
    {"--hours", "how many hours of it each point has"},
    {"--receivers", "the triangle that each point lies on, (N,)"},
    {"--packed", "eight answers a byte"},
    {"--time", "seconds of the animation; default its begin"},
    {"--json", "print counts as one JSON object"},
};

constexpr BasicOption kBench[] = {
    {"--paper", "what section 5 of Robert and Schoepke 2006 measures"},
    {"--baseline", "whole frames beside Embree's"},
    {"--bart", "BART's scene Robots, which the paper uses"},
    {"--quick", "a trial of a few seconds"},
    {"--output", "the folder of the page and its numbers"},
    {"--json", "the numbers as JSON"},
};

constexpr BasicOption kJoin[] = {
    {"TILE", "x,y,width,height=FILE: a region and its file"},
    {"--output", "the whole picture: .png, .exr or .npy, as the tiles"},
    {"--size", "pixels that the tiles have to cover"},
};

constexpr auto kHelps = std::to_array<BasicHelp>({
    {"render", "render SCENE [-o FILE] [OPTIONS]",
        "  firsthit render builtin:torus -o torus.png\n"
        "  firsthit render bunny.stl -o bunny.png --size 800x600 --background transparent\n"
        "  firsthit render bunny.stl -o turn.mp4 --turntable 72 --size 800x600\n"
        "  firsthit render walk.glb -o walk.mp4\n"
        "  firsthit render walk.glb -o walk_%04d.png --frames clip --resume\n"
        "  firsthit render part.stl --aov depth=depth.npy --aov instance=ids.npy\n"
        "  firsthit render town.glb --exr town.exr --manifest town.json\n",
        kRender},
    {"view", "view SCENE [OPTIONS]",
        "  firsthit view bunny.stl\n"
        "  firsthit view walk.glb --size 1920x1080\n"
        "  firsthit view builtin:robots --engine hybrid --shadows map\n"
        "  firsthit view bunny.stl --serve 8080\n"
        "  firsthit view builtin:robots --script actions.txt --screenshot window.png\n",
        kView},
    {"info", "info SCENE [--json]",
        "  firsthit info bunny.stl\n"
        "  firsthit info walk.glb --json\n"
        "  firsthit info frames/%04d.obj --fps 30\n",
        kInfo},
    {"join", "join TILE... -o FILE",
        "  firsthit join 0,0,1280,360=top.png 0,360,1280,360=bottom.png -o room.png\n", kJoin},
    {"mask", "mask SCENE -o FILE [OPTIONS]",
        "  firsthit mask builtin:robots -o masks.json\n"
        "  firsthit mask town.glb -o masks.json --by node --picture town.png\n"
        "  firsthit mask walk.glb -o masks.json --frames clip --picture walk_%04d.png\n",
        kMask},
    {"visible", "visible SCENE [-o FILE] [OPTIONS]",
        "  firsthit visible builtin:robots > seen.csv\n"
        "  firsthit visible part.stl --view top -o seen.json\n"
        "  firsthit visible part.stl --turntable 72 -o pixels.npy\n",
        kVisible},
    {"compare", "compare SCENE --against brute|embree|cpu [OPTIONS]",
        "  firsthit compare builtin:torus --against brute --shadows exact\n"
        "  firsthit compare builtin:robots --against embree --time 5\n"
        "  firsthit compare builtin:robots --engine gpu --against cpu\n",
        kCompare},
    {"cast", "cast SCENE --rays FILE.npy -o FILE.npz [OPTIONS]",
        "  firsthit cast bunny.stl --rays rays.npy -o hits.npz\n"
        "  firsthit cast bunny.stl --origins eye.npy --directions beams.npy -o scan.npz\n",
        kCast},
    {"occlusion", "occlusion SCENE --points FILE.npy -o FILE.npy [OPTIONS]",
        "  firsthit occlusion bunny.stl --points p.npy --direction -1,-2,0.5 -o shade.npy\n"
        "  firsthit occlusion builtin:robots --points p.npy --light 9,16,7 -o dark.npy\n",
        kOcclusion},
    {"bench", "bench --paper|--baseline [OPTIONS]",
        "  firsthit bench --paper\n"
        "  firsthit bench --baseline -o baseline/\n"
        "  firsthit bench --paper --quick --json -\n",
        kBench},
});

} // namespace

std::span<const BasicHelp> basic_helps()
{
    return kHelps;
}

} // namespace firsthit::cli
