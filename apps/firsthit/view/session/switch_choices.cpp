// switch_choices.cpp - what a switch offers for the scene that is looked at.
#include "view/session/switch_choices.h"

#include <fmt/format.h>

namespace firsthit::cli::view {
namespace {

/// The longest range of whole numbers that is slid through.
constexpr double kMostSlid = 300;

template <class Named>
void add_named(Choices& choices, const std::vector<Named>& all, const char* kind)
{
    for (std::size_t k = 0; k < all.size(); ++k) {
        choices.shown.push_back(all[k].name.empty() ? fmt::format("{} {}", kind, k) : all[k].name);
        choices.values.push_back(fmt::format("{}", k));
    }
}

} // namespace

Choices choices_of(const Switch& one, const Scene& scene)
{
    if (!one.words.empty()) return {one.words, one.words};
    Choices choices;
    if (one.name == "clip") {
        choices = {{"-1"}, {"at rest"}};
        add_named(choices, scene.clips, "clip");
    } else if (one.name == "camera") {
        add_named(choices, scene.cameras, "camera");
    }
    return choices;
}

SwitchRange range_of(const Switch& one, const ViewScene& scene, const ViewState& state)
{
    if (one.name == "time") return {scene.begin_s(state.clip), scene.end_s(state.clip)};
    return {one.least, one.most};
}

bool can_slide(const Switch& one, const SwitchRange& range)
{
    return range.most - range.least <= kMostSlid && (one.whole || one.name == "time");
}

double step_of(const Switch& one)
{
    return one.whole ? 1 : one.name == "rate" ? 5 : 0.25;
}

} // namespace firsthit::cli::view
