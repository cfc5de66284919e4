// finer_view.h - the samples of a picture as the pixels of a larger one.
#pragma once

#include <firsthit/view.h>

namespace firsthit {

/// The view of a picture n times as wide and high, whose pixels are the view's n x n samples.
inline View finer(View view, int n)
{
    view.width *= n, view.height *= n;
    Region& region = view.region;
    region = {region.x * n, region.y * n, region.width * n, region.height * n};
    Camera& camera = view.camera;
    if (camera.focal) *camera.focal *= double(n);
    if (camera.principal_point) *camera.principal_point *= double(n);
    camera.skew *= double(n);
    return view;
}

} // namespace firsthit
