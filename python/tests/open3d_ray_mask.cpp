// open3d_ray_mask.cpp - loaded before Open3D 0.16 (LD_PRELOAD), gives the rays that it casts a mask that hits all geometry.
// Open3D leaves the mask 0, with which an Embree that is built with masks of rays, as Debian's is, hits nothing.
#include <embree3/rtcore.h>

#include <dlfcn.h>

#include <cstddef>

extern "C" void rtcIntersect1M(RTCScene scene, RTCIntersectContext* context, RTCRayHit* rays,
    unsigned int count, std::size_t stride)
{
    // Not RTLD_NEXT: Python's modules and what they need are not in the global scope.
    static const auto next = reinterpret_cast<decltype(&rtcIntersect1M)>(
        dlsym(dlopen("libembree3.so.3", RTLD_LAZY), "rtcIntersect1M"));
    for (unsigned int k = 0; k < count; ++k) {
        auto* ray = reinterpret_cast<RTCRayHit*>(reinterpret_cast<char*>(rays) + k * stride);
        ray->ray.mask = 0xFFFFFFFFu;
    }
    next(scene, context, rays, count, stride);
}
