// bars.cpp - the times of stages as stacked bars over time.
#include "view/window/panels.h"

#include "view/session/process_memory.h"
#include "view/session/stages.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <deque>
#include <vector>

namespace firsthit::cli::view {
namespace {

constexpr std::size_t kBars = 100;
const ImVec2 kBarsSize{345, 110};
constexpr float kColumn = 118; // of the legend

ImU32 shade_of(const std::array<std::uint8_t, 3>& color)
{
    return IM_COL32(color[0], color[1], color[2], 255);
}

/// What the bars' full height stands for: all of them, but for few that are much longer.
double full_height_ms(const std::deque<HistoryEntry>& frames, std::size_t count)
{
    std::vector<double> ms;
    for (std::size_t k = frames.size() - count; k < frames.size(); ++k)
        ms.push_back(frames[k].made_ms);
    return std::max(1.0, std::min(quantile(ms, 1), 3 * quantile(ms, 0.5)));
}

/// One frame from below: its stages, and what is in none of them.
void draw_bar(
    ImDrawList& list, const HistoryEntry& frame, ImVec2 foot, float width, double px_per_ms)
{
    float y = foot.y;
    const auto add = [&](double ms, const std::array<std::uint8_t, 3>& color) {
        const float next = std::max(foot.y - kBarsSize.y, y - float(ms * px_per_ms));
        if (y - next > 0.3f)
            list.AddRectFilled({foot.x, next}, {foot.x + width, y}, shade_of(color));
        y = next;
    };
    for (const Stage& stage : all_stages()) add(frame.stats.*stage.ms, stage.color);
    add(other_ms(frame.stats, frame.made_ms), kOtherStage);
}

void draw_legend(const Stats& stats, double made_ms)
{
    int column = 0;
    const auto entry = [&](const char* name, double ms, ImU32 color) {
        if (column++ % 3 != 0) ImGui::SameLine(float((column - 1) % 3) * kColumn);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(fmt::format("{:<7}{:6.1f}", name, ms).c_str());
        ImGui::PopStyleColor();
    };
    for (const Stage& stage : all_stages())
        if (stats.*stage.ms > 0) entry(stage.name, stats.*stage.ms, shade_of(stage.color));
    entry("other", other_ms(stats, made_ms), IM_COL32(160, 160, 160, 255));
}

} // namespace

void draw_bars(const ViewSession& session, Clock::time_point now)
{
    const auto& frames = session.history().frames();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - 10, screen.y - 10}, ImGuiCond_Always, {1, 1});
    ImGui::SetNextWindowBgAlpha(0.8f);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoSavedSettings;
    if (!ImGui::Begin("Times (B)", nullptr, kFlags) || frames.empty()) {
        ImGui::End();
        return;
    }
    const std::size_t count = std::min(kBars, frames.size());
    const double most = full_height_ms(frames, count);
    const HistoryEntry& last = frames.back();
    ImGui::TextUnformatted(
        fmt::format("last frame {:.1f} ms, full height {:.1f} ms", last.made_ms, most).c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(kBarsSize);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(
        corner, {corner.x + kBarsSize.x, corner.y + kBarsSize.y}, IM_COL32(20, 20, 24, 255));
    const float width = kBarsSize.x / float(kBars);
    for (std::size_t k = 0; k < count; ++k) {
        const float x = corner.x + kBarsSize.x - float(count - k) * width;
        draw_bar(list, frames[frames.size() - count + k], {x, corner.y + kBarsSize.y},
            std::max(1.0f, width - 0.5f), double(kBarsSize.y) / most);
    }
    draw_legend(last.stats, last.made_ms);
    ImGui::TextUnformatted(fmt::format("{:.0f} frames a second, 1 % low {:.0f}",
        session.history().rate(now), session.history().low_rate())
                               .c_str());
    const std::shared_ptr<const ShownFrame> frame = session.latest();
    const char* engine = !frame                                   ? ""
                         : frame->engine.engine == Engine::cpu    ? "cpu"
                         : frame->engine.engine == Engine::hybrid ? "hybrid"
                                                                  : "gpu";
    ImGui::TextUnformatted(fmt::format("{} | {} triangles, {} in view | {:.0f} MB", engine,
        last.stats.triangles, last.stats.in_view, memory_mb())
                               .c_str());
    ImGui::End();
}

} // namespace firsthit::cli::view
