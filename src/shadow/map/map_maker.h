// map_maker.h - who makes the depths of shadow maps: our rasteriser, or OpenGL.
#pragma once

#include "base/tasks.h"

#include <firsthit/scene.h>

namespace firsthit {

struct ShadowMaps;

class MapMaker {
  public:
    MapMaker() = default;
    MapMaker(const MapMaker&) = delete;
    MapMaker& operator=(const MapMaker&) = delete;
    virtual ~MapMaker() = default;

    /// Makes maps.changed from their sources: matrix, origin, offset, depth and farthest of each.
    virtual void make(const World& world, ShadowMaps& maps, Tasks& tasks) = 0;
};

} // namespace firsthit
