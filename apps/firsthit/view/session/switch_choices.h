// switch_choices.h - what a switch offers for the scene that is looked at.
#pragma once

#include "view/frames/view_scene.h"
#include "view/session/switches.h"

#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Values to choose among, and how each is shown; empty: a number is typed or slid.
struct Choices {
    std::vector<std::string> values{}, shown{};
};

/// Words of a switch, the clips and the cameras of a scene.
Choices choices_of(const Switch& one, const Scene& scene);

/// The least and the greatest value of a number.
struct SwitchRange {
    double least = 0, most = 0;
};

/// That of the time is the clip's; it is empty where nothing moves.
SwitchRange range_of(const Switch& one, const ViewScene& scene, const ViewState& state);

/// Whether a number's range is so short that it can be slid through.
bool can_slide(const Switch& one, const SwitchRange& range);

/// A step of a number that is typed.
double step_of(const Switch& one);

} // namespace firsthit::cli::view
