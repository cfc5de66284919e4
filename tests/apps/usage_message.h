// usage_message.h - what a UsageError says.
#pragma once

#include "usage.h"

#include <string>

namespace firsthit::cli {

template <class Action>
std::string usage_message(const Action& action)
{
    try {
        action();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace firsthit::cli
