// embree_handles.h - owns the handles of an Embree scene and releases them in order.
//
// A child process after fork() leaks them, because it does not have Embree's threads.
#pragma once

#include "base/process_owned.h"

#include <firsthit/error.h>

#include <embree3/rtcore.h>
#include <fmt/format.h>

namespace firsthit {

struct EmbreeHandles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    RTCGeometry geometry = nullptr;

    EmbreeHandles() = default;
    EmbreeHandles(const EmbreeHandles&) = delete;
    EmbreeHandles& operator=(const EmbreeHandles&) = delete;
    ~EmbreeHandles()
    {
        if (!home_.is_this()) return;
        if (geometry) rtcReleaseGeometry(geometry);
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    /// throws  DeviceError if Embree has failed since the last call
    void check() const
    {
        if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
            throw DeviceError(fmt::format("Embree failed with error {}", int(error)));
    }

  private:
    HomeProcess home_;
};

} // namespace firsthit
