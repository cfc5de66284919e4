// keys_page.cpp - the page that lists all keys.
#include "view/window/panels.h"

#include <imgui.h>

#include <array>

namespace firsthit::cli::view {

void draw_help()
{
    static constexpr std::array<std::array<const char*, 2>, 26> kKeys = {{
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
        {"R, or drop a file", "read the file again; read another"},
        {"F12", "save the picture as firsthit-001.png"},
        {"shift + F12", "begin or end a film of what is shown"},
        {"?   F1", "this page"},
        {"Escape", "close this page, unselect, end"},
    }};
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(0.93f);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("Keys (?)", nullptr, kFlags)) {
        for (const auto& [keys, text] : kKeys) {
            ImGui::TextUnformatted(keys);
            ImGui::SameLine(250);
            ImGui::TextUnformatted(text);
        }
    }
    ImGui::End();
}

} // namespace firsthit::cli::view
