// map_maker.h - interface of whatever makes shadow maps in the place of our rasteriser: OpenGL.
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

    /// Makes the maps listed in maps.changed from their sources: fills in matrix, origin, offset,
    /// depth and farthest of each.
    virtual void make(const World& world, ShadowMaps& maps, Tasks& tasks) = 0;
};

} // namespace firsthit
