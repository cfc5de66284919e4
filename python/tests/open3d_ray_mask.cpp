// open3d_ray_mask.cpp - loaded before Open3D 0.16 (LD_PRELOAD), gives the rays that it casts a mask that hits all geometry.
// Open3D leaves the mask 0, with which an Embree that is built with masks of rays, as Debian's is, hits nothing.
#include <embree3/rtcore.h>

#include <dlfcn.h>

#include <cstddef>

namespace {

/// Embree's own function of that name. Not RTLD_NEXT: Python's modules and what they need are not in the global scope.
template <class Function>
Function* next(Function*, const char* name)
{
    return reinterpret_cast<Function*>(dlsym(dlopen("libembree3.so.3", RTLD_LAZY), name));
}

} // namespace

extern "C" void rtcIntersect1M(RTCScene scene, RTCIntersectContext* context, RTCRayHit* rays,
    unsigned int count, std::size_t stride)
{
    static const auto embree = next(&rtcIntersect1M, "rtcIntersect1M");
    for (unsigned int k = 0; k < count; ++k) {
        auto* ray = reinterpret_cast<RTCRayHit*>(reinterpret_cast<char*>(rays) + k * stride);
        ray->ray.mask = 0xFFFFFFFFu;
    }
    embree(scene, context, rays, count, stride);
}

extern "C" void rtcOccluded1M(RTCScene scene, RTCIntersectContext* context, RTCRay* rays,
    unsigned int count, std::size_t stride)
{
    static const auto embree = next(&rtcOccluded1M, "rtcOccluded1M");
    for (unsigned int k = 0; k < count; ++k) {
        auto* ray = reinterpret_cast<RTCRay*>(reinterpret_cast<char*>(rays) + k * stride);
        ray->mask = 0xFFFFFFFFu;
    }
    embree(scene, context, rays, count, stride);
}
