// builtin.cpp - finds a scene of the library's own by its name.
#include "samples/builtin.h"
#include "io/text_cursor.h"
#include "io/parse_number.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <string>

namespace firsthit {
namespace {

constexpr std::uint64_t kDefaultWave = 100'000;

/// "n=N"
std::uint64_t wave_parameter(std::string_view parameters)
{
    const auto fail = [&](const char* why) {
        throw ArgumentError(
            fmt::format("builtin:wave?{}: {}; accepted is n=N, N triangles from {} to {}",
                printable(parameters), why, kMinWave, kMaxWave));
    };
    const std::size_t equals = parameters.find('=');
    if (parameters.substr(0, equals) != "n") fail("unknown parameter");
    std::optional<std::int64_t> n;
    if (equals != std::string_view::npos) n = parse_integer(parameters.substr(equals + 1));
    if (!n) fail("n is no whole number");
    if (*n < static_cast<std::int64_t>(kMinWave) || *n > static_cast<std::int64_t>(kMaxWave))
        fail("n is out of range");
    return static_cast<std::uint64_t>(*n);
}

} // namespace

Scene make_builtin(std::string_view name)
{
    const std::size_t mark = name.find('?');
    const std::string_view base = name.substr(0, mark);
    const bool has_parameters = mark != std::string_view::npos;
    if (base == "wave")
        return make_wave(has_parameters ? wave_parameter(name.substr(mark + 1)) : kDefaultWave);
    if (base != "torus" && base != "robots" && base != "room")
        throw ArgumentError(fmt::format("builtin:{}: unknown; accepted are builtin:torus, "
                                        "builtin:robots, builtin:room, builtin:wave?n=N",
            printable(name)));
    if (has_parameters)
        throw ArgumentError(
            fmt::format("builtin:{}: {} takes no parameters", printable(name), base));
    return base == "torus" ? make_torus() : base == "robots" ? make_robots() : make_room();
}

} // namespace firsthit
