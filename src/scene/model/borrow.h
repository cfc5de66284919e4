// borrow.h - a scene for a world that does not outlive it.
#pragma once

#include <firsthit/scene.h>

#include <memory>

namespace firsthit {

/// Shares nothing: whoever calls this keeps the scene alive for as long as a world has it.
inline std::shared_ptr<const Scene> borrow(const Scene& scene)
{
    return {std::shared_ptr<const void>(), &scene};
}

} // namespace firsthit
