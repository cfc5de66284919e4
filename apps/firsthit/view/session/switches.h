// switches.h - every switch of the viewer by its name: for panels, scripts and whoever else drives a session.
#pragma once

#include "view/frames/view_state.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// A choice among words, or a number.
struct Switch {
    std::string name{};               // as scripts say it
    std::string group{};              // the part of the panel that it stands in
    std::string text{};               // one short line
    std::vector<std::string> words{}; // the values that it takes; empty: a number
    double least = 0;                 // of a number
    double most = 0;                  // of a number
    bool whole = false;               // the number has no fraction
    std::function<std::string(const ViewState&)> get{};
    std::function<void(ViewState&, const std::string&)> set{}; // a value that was checked
};

/// All of them, in the order of the panel.
std::span<const Switch> all_switches();

/// throws  UsageError: no such switch; lists all
const Switch& switch_named(const std::string& name);

/// Sets a switch. throws  UsageError: the value is not accepted; says which are
void choose(const Switch& chosen, const std::string& value, ViewState& state);

/// "on" or "off", a word, or a number as it is typed: whether two values of a switch are the same.
bool same_value(const Switch& chosen, const std::string& a, const std::string& b);

} // namespace firsthit::cli::view
