// panels.h - what stands over the picture: switches, times, the pointer's pixel, the page of keys.
#pragma once

#include "view/session/view_session.h"

namespace firsthit::cli::view {

/// Draws all panels of a session, between ImGui's NewFrame and Render. What is changed in them is chosen in
/// the session.
void draw_panels(ViewSession& session, Clock::time_point now);

/// The times of stages as stacked bars, and counts.
void draw_bars(const ViewSession& session, Clock::time_point now);

/// The page of keys.
void draw_help();

} // namespace firsthit::cli::view
