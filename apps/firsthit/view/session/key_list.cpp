// key_list.cpp - the page of keys: what hands and keys do.
#include "view/session/key_list.h"

namespace firsthit::cli::view {
namespace {

constexpr KeyLine kKeys[] = {
    {"left drag", "turn round the scene"},
    {"middle drag, shift + left drag", "move sideways"},
    {"right drag", "look around"},
    {"wheel, + and -", "nearer and farther, towards the pointer"},
    {"W A S D, E Q", "fly: ahead, left, back, right; up, down"},
    {"arrow keys", "turn by steps"},
    {"1  3  7  0", "front, right, top, corner; with shift back, left, bottom"},
    {"F, shift + F", "frame what is selected, or all"},
    {"Home", "the first camera again"},
    {"Page up and down", "cameras of the file"},
    {"T", "turntable"},
    {"C", "copy the camera as options of firsthit render"},
    {"", ""},
    {"space", "play and pause"},
    {". and ,", "step ahead and back"},
    {"[ and ]   L", "half and twice as fast; loop"},
    {"", ""},
    {"click, at rest", "select the instance under the pointer, or none"},
    {"V, shift + V", "ways of looking: colour, items, depth, ..."},
    {"G   H", "next engine; next kind of shadows"},
    {"Tab   B   I", "switches; times; what is under the pointer"},
    {"R, or drop a file", "read the file again; read another", Front::window},
    {"R", "read the file again", Front::page},
    {"F12", "save the picture as firsthit-001.png", Front::window},
    {"F12", "save the picture", Front::page},
    {"shift + F12", "begin or end a film of what is shown", Front::window},
    {"?   F1", "this page"},
    {"Escape", "close this page, unselect, end", Front::window},
    {"Escape", "close this page, unselect", Front::page},
};

} // namespace

std::vector<KeyLine> keys_of(Front front)
{
    std::vector<KeyLine> lines;
    for (const KeyLine& line : kKeys)
        if (line.front == Front::any || line.front == front) lines.push_back(line);
    return lines;
}

} // namespace firsthit::cli::view
