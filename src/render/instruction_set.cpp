// instruction_set.cpp - which kernels run here.
#include "base/simd_targets.h"

#include <firsthit/render.h>

namespace firsthit {

std::string instruction_set()
{
    return chosen_target_name();
}

std::string version()
{
    return FIRSTHIT_VERSION;
}

} // namespace firsthit
