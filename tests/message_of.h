// message_of.h - what an error says.
#pragma once

#include <string>

namespace firsthit {

/// The message of the error of that kind that an action throws, or "no error". Errors of other
/// kinds pass through.
template <class Kind, class Action>
std::string message_of(const Action& action)
{
    try {
        action();
    } catch (const Kind& error) {
        return error.what();
    }
    return "no error";
}

} // namespace firsthit
