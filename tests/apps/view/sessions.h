// sessions.h - what tests of sessions share.
#pragma once

#include "view/session/view_session.h"

#include <string>
#include <thread>

namespace firsthit::cli::view {

inline RenderOptions options_of(const std::string& scene)
{
    RenderOptions options;
    options.scene.name = scene;
    options.output = "-";
    options.camera.size = Size{160, 120};
    options.threads = 2;
    return options;
}

/// Lets a session go on until its picture is at rest. False: it took a minute.
inline bool comes_to_rest(ViewSession& session)
{
    const auto begin = Clock::now();
    while (Clock::now() - begin < std::chrono::minutes(1)) {
        session.update();
        if (session.is_at_rest(Clock::now())) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

} // namespace firsthit::cli::view
