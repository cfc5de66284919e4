// session_messages.cpp - what pages are told about a session, as JSON.
#include "view/serve/session_messages.h"

#include "options/engine_options.h"
#include "view/session/key_list.h"
#include "view/session/process_memory.h"
#include "view/session/stages.h"
#include "view/session/switch_choices.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::view {
namespace {

using Json = nlohmann::json;

/// The panels of a page are its own: each viewer opens and closes them alone.
constexpr std::string_view kOwnGroup = "window";
/// Most frames that one message tells of.
constexpr std::uint64_t kMostBars = 100;

/// Names of files and scenes may be in any encoding: what is no UTF-8 is replaced.
std::string spelled_json(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json described_switch(const Switch& one, const ViewSession& session)
{
    const Choices choices = choices_of(one, session.scene().first());
    const SwitchRange range{one.least, one.most};
    return {{"name", one.name}, {"group", one.group}, {"text", one.text},
        {"values", choices.values}, {"shown", choices.shown}, {"least", range.least},
        {"most", range.most}, {"whole", one.whole}, {"slides", can_slide(one, range)},
        {"step", step_of(one)}};
}

/// Hundredths of a millisecond are enough for bars.
double rounded_ms(double ms)
{
    return std::round(ms * 100) / 100;
}

} // namespace

std::string text_message(const char* kind, const std::string& text)
{
    return spelled_json({{"kind", kind}, {"text", text}});
}

std::string described(const ViewSession& session)
{
    Json switches = Json::array(), keys = Json::array(), stages = Json::array();
    for (const Switch& one : all_switches())
        if (one.group != kOwnGroup) switches.push_back(described_switch(one, session));
    for (const KeyLine& line : keys_of(Front::page))
        keys.push_back(Json::array({line.keys, line.text}));
    for (const Stage& stage : all_stages())
        stages.push_back({{"name", stage.name}, {"color", stage.color}});
    stages.push_back({{"name", "other"}, {"color", kOtherStage}});
    return spelled_json(
        {{"kind", "session"}, {"scene", session.scene().options().scene.shown_name()},
            {"switches", switches}, {"keys", keys}, {"stages", stages}});
}

std::string status_of(const ViewSession& session, Clock::time_point now, std::size_t viewers)
{
    const ViewState& state = session.state();
    Json values = Json::object();
    for (const Switch& one : all_switches())
        if (one.group != kOwnGroup) values[one.name] = one.get(state);
    Json status{{"kind", "status"}, {"corner", session.corner(now)}, {"message", session.message()},
        {"rest", session.is_at_rest(now)}, {"values", values},
        {"begin", session.scene().begin_s(state.clip)}, {"end", session.scene().end_s(state.clip)},
        {"width", session.width()}, {"height", session.height()}, {"viewers", viewers}};
    if (const auto frame = session.latest()) // whose picture is the one of this status, at rest
        status["state"] = static_cast<std::uint32_t>(frame->request.number);
    if (const std::optional<Pick> found = session.latest_pick())
        status["pick"] = {{"x", found->x}, {"y", found->y}, {"lines", told(*found)}};
    return spelled_json(status);
}

std::string bars_of(const ViewSession& session, Clock::time_point now, std::uint64_t known)
{
    const FrameHistory& history = session.history();
    const auto& frames = history.frames();
    const std::uint64_t fresh = history.count() > known ? history.count() - known : 0;
    const auto shown = std::min({fresh, kMostBars, std::uint64_t(frames.size())});
    Json bars = Json::array();
    for (std::size_t k = frames.size() - std::size_t(shown); k < frames.size(); ++k) {
        Json bar = Json::array();
        for (const Stage& stage : all_stages())
            bar.push_back(rounded_ms(frames[k].stats.*stage.ms));
        bar.push_back(rounded_ms(other_ms(frames[k].stats, frames[k].made_ms)));
        bars.push_back({{"ms", rounded_ms(frames[k].made_ms)}, {"stages", bar}});
    }
    Json told{{"kind", "bars"}, {"frames", bars}, {"rate", std::round(history.rate(now))},
        {"low", std::round(history.low_rate())}, {"memory_mb", std::round(memory_mb())}};
    if (const auto frame = session.latest()) {
        told["engine"] = engine_name(frame->engine.engine);
        told["triangles"] = frame->stats.triangles;
        told["in_view"] = frame->stats.in_view;
    }
    return spelled_json(told);
}

} // namespace firsthit::cli::view
