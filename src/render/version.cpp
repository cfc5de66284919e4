// version.cpp - the version of the library and the instruction set that it uses.
#include "base/instruction_set.h"

#include <firsthit/render.h>

namespace firsthit {

std::string instruction_set()
{
    select_instruction_set();
    return chosen_instruction_set();
}

std::string version()
{
    return FIRSTHIT_VERSION;
}

} // namespace firsthit
