// posed.h - scenes and worlds as Python holds them.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>
#include <memory>
#include <shared_mutex>
#include <utility>

namespace firsthit::python {

/// A scene, and how it is posed where nobody says it.
struct LoadedScene {
    std::shared_ptr<const Scene> scene;
    std::int32_t clip = 0;
    bool studio = false; // its lights and background are the studio's, of which the sky is a part
};

/// A scene at one time. What reads it holds `use` shared; what writes it (posing, hanging lights on a camera), alone.
struct PosedWorld {
    LoadedScene source;
    World world;
    std::shared_mutex use;
};

} // namespace firsthit::python
