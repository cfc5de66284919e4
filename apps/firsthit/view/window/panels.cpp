// panels.cpp - the panel of switches, the corner and the pointer's pixel.
#include "view/window/panels.h"

#include "common/parse.h"
#include "view/session/switch_choices.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace firsthit::cli::view {
namespace {

constexpr float kMargin = 10;
constexpr float kPanelWidth = 320;
constexpr ImGuiWindowFlags kText =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings;

/// Chooses, and says what is wrong where it cannot be.
void choose_in(ViewSession& session, const std::string& name, const std::string& value)
{
    try {
        session.choose_switch(name, value);
    } catch (const std::exception& error) {
        session.say(error.what());
    }
}

bool combo(
    ViewSession& session, const Switch& one, const Choices& choices, const std::string& value)
{
    const auto& [values, shown] = choices;
    const auto at = std::find(values.begin(), values.end(), value);
    const std::string preview =
        at == values.end() ? value : shown[std::size_t(at - values.begin())];
    if (!ImGui::BeginCombo(one.name.c_str(), preview.c_str())) return false;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (ImGui::Selectable(fmt::format("{}##{}", shown[k], k).c_str(), values[k] == value))
            choose_in(session, one.name, values[k]);
    ImGui::EndCombo();
    return true;
}

void number_of(ViewSession& session, const Switch& one, const std::string& value)
{
    double number = parse_number(value);
    SwitchRange range = range_of(one, session.scene(), session.state());
    if (one.name == "time") {
        number = session.state().time_s;
        if (!(range.most > range.least)) return;
    }
    const bool slides = can_slide(one, range);
    bool changed = false;
    if (slides && one.whole) {
        int whole = int(number);
        changed = ImGui::SliderInt(one.name.c_str(), &whole, int(range.least), int(range.most),
            "%d", ImGuiSliderFlags_AlwaysClamp);
        number = whole;
    } else if (slides) {
        changed = ImGui::SliderScalar(one.name.c_str(), ImGuiDataType_Double, &number, &range.least,
            &range.most, "%.3f s", ImGuiSliderFlags_AlwaysClamp);
    } else {
        changed = ImGui::InputDouble(
            one.name.c_str(), &number, step_of(one), 0, one.whole ? "%.0f" : "%.4g");
    }
    if (changed)
        choose_in(
            session, one.name, fmt::format("{}", std::clamp(number, range.least, range.most)));
}

void switch_row(ViewSession& session, const Switch& one)
{
    const std::string value = one.get(session.state());
    const Choices choices = choices_of(one, session.scene().first());
    if (one.words.size() == 2 && one.words[0] == "off") {
        bool on = value == "on";
        if (ImGui::Checkbox(one.name.c_str(), &on)) choose_in(session, one.name, on ? "on" : "off");
    } else if (!choices.values.empty()) {
        combo(session, one, choices, value);
    } else if (one.name == "selected") {
        ImGui::Text(
            "%s", session.state().selected < 0
                      ? "click selects an instance"
                      : fmt::format("selected: instance {}", session.state().selected).c_str());
        return;
    } else if (one.name != "camera") { // of a file without any
        number_of(session, one, value);
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", one.text.c_str());
}

/// Files to open, and what can be saved.
void draw_files(ViewSession& session)
{
    if (!ImGui::CollapsingHeader("file", ImGuiTreeNodeFlags_DefaultOpen)) return;
    static std::array<char, 1024> name{};
    if (ImGui::InputTextWithHint("open", "a file; or drop it here", name.data(), name.size(),
            ImGuiInputTextFlags_EnterReturnsTrue) &&
        name[0] != 0)
        session.open(name.data());
    const std::vector<std::string>& recent = session.recent_files();
    if (!recent.empty() && ImGui::BeginCombo("recent", "files of before")) {
        for (const std::string& file : std::vector<std::string>(recent))
            if (ImGui::Selectable(file.c_str())) session.open(file);
        ImGui::EndCombo();
    }
    if (ImGui::Button("picture (F12)")) session.key("f12", true);
    ImGui::SameLine();
    if (ImGui::Button(session.is_recording() ? "end film###film" : "film###film"))
        session.key("shift+f12", true);
    ImGui::SameLine();
    if (ImGui::Button("copy camera")) session.key("c", true);
}

void draw_switches(ViewSession& session)
{
    const float height = ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowPos({kMargin, kMargin}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(
        {kPanelWidth, std::min(860.0f, height - 2 * kMargin)}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Switches (Tab)", nullptr,
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
        ImGui::TextDisabled("? lists the keys");
        ImGui::PushItemWidth(-120);
        draw_files(session);
        std::string group;
        bool open = false;
        for (const Switch& one : all_switches()) {
            if (one.group != group) {
                group = one.group;
                const bool first = group == "look" || group == "animation" || group == "frame";
                open = ImGui::CollapsingHeader(
                    group.c_str(), first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
            }
            if (open) switch_row(session, one);
        }
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

void draw_corner(const ViewSession& session, Clock::time_point now)
{
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - kMargin, kMargin}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowBgAlpha(0.65f);
    if (ImGui::Begin("corner", nullptr, kText)) ImGui::TextUnformatted(session.corner(now).c_str());
    ImGui::End();
}

void draw_message(const ViewSession& session)
{
    const std::string message = session.message();
    if (message.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x / 2, size.y - kMargin}, ImGuiCond_Always, {0.5f, 1});
    ImGui::SetNextWindowBgAlpha(0.85f);
    if (ImGui::Begin("message", nullptr, kText)) {
        ImGui::PushTextWrapPos(size.x * 0.7f);
        ImGui::TextUnformatted(message.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

void draw_pick(const ViewSession& session)
{
    const std::optional<Pick> found = session.latest_pick();
    if (!found || ImGui::GetIO().WantCaptureMouse) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos, size = ImGui::GetIO().DisplaySize;
    // On the side of the pointer where there is room.
    const ImVec2 side(
        mouse.x > size.x * 0.65f ? 1.0f : 0.0f, mouse.y > size.y * 0.65f ? 1.0f : 0.0f);
    const ImVec2 place(
        mouse.x + (side.x > 0 ? -18.0f : 18.0f), mouse.y + (side.y > 0 ? -18.0f : 18.0f));
    ImGui::SetNextWindowPos(place, ImGuiCond_Always, side);
    ImGui::SetNextWindowBgAlpha(0.8f);
    if (ImGui::Begin("pixel", nullptr, kText))
        for (const std::string& line : told(*found)) ImGui::TextUnformatted(line.c_str());
    ImGui::End();
}

} // namespace

void draw_panels(ViewSession& session, Clock::time_point now)
{
    const ViewState& state = session.state();
    if (state.panel) draw_switches(session);
    if (state.bars) draw_bars(session, now);
    if (state.corner) draw_corner(session, now);
    if (state.hover) draw_pick(session);
    if (state.help) draw_help();
    draw_message(session);
}

} // namespace firsthit::cli::view
