// embree_packets.h - Embree's types and functions for packets of 8 and of 16 rays, for templates.
#pragma once

#include <embree3/rtcore.h>

namespace firsthit {

/// kRays  8 or 16
template <int kRays>
struct EmbreePacket;

template <>
struct EmbreePacket<8> {
    using RayHit = RTCRayHit8;
    using Ray = RTCRay8;
    static void intersect(
        const int* valid, RTCScene scene, RTCIntersectContext& context, RayHit& rays)
    {
        rtcIntersect8(valid, scene, &context, &rays);
    }
    static void occluded(const int* valid, RTCScene scene, RTCIntersectContext& context, Ray& rays)
    {
        rtcOccluded8(valid, scene, &context, &rays);
    }
};

template <>
struct EmbreePacket<16> {
    using RayHit = RTCRayHit16;
    using Ray = RTCRay16;
    static void intersect(
        const int* valid, RTCScene scene, RTCIntersectContext& context, RayHit& rays)
    {
        rtcIntersect16(valid, scene, &context, &rays);
    }
    static void occluded(const int* valid, RTCScene scene, RTCIntersectContext& context, Ray& rays)
    {
        rtcOccluded16(valid, scene, &context, &rays);
    }
};

/// Tells Embree that the rays of a packet are similar.
inline RTCIntersectContext coherent_context()
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

} // namespace firsthit
