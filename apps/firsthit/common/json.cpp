// json.cpp - objects that keep the order in which they were written.
#include "common/json.h"

namespace firsthit::cli {

std::string to_text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace firsthit::cli
