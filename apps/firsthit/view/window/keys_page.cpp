// keys_page.cpp - the page that lists all keys.
#include "view/session/key_list.h"
#include "view/window/panels.h"

#include <imgui.h>

namespace firsthit::cli::view {

void draw_help()
{
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(0.93f);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("Keys (?)", nullptr, kFlags)) {
        for (const KeyLine& line : keys_of(Front::window)) {
            ImGui::TextUnformatted(line.keys);
            ImGui::SameLine(250);
            ImGui::TextUnformatted(line.text);
        }
    }
    ImGui::End();
}

} // namespace firsthit::cli::view
