# precompile.cmake - headers that are parsed once for a target instead of once for each of its files.
#
# Only headers of others: one of ours would have everything built again when it changes. Every file still
# includes what it uses, so that it compiles without them: the presets fuzz and msan, and clang-tidy, do without
# (CMAKE_DISABLE_PRECOMPILE_HEADERS).
set(FIRSTHIT_STANDARD_HEADERS
    <algorithm> <array> <atomic> <bit> <cmath> <cstddef> <cstdint> <cstring> <filesystem> <functional> <limits>
    <map> <memory> <mutex> <numbers> <optional> <span> <string> <string_view> <utility> <variant> <vector>
    <fmt/format.h>
    <glm/common.hpp> <glm/geometric.hpp> <glm/gtc/quaternion.hpp> <glm/mat3x3.hpp> <glm/mat4x4.hpp>
    <glm/matrix.hpp> <glm/trigonometric.hpp> <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp>)

# firsthit_precompile(target header...): the standard headers, and these.
function(firsthit_precompile target)
    target_precompile_headers(${target} PRIVATE ${FIRSTHIT_STANDARD_HEADERS} ${ARGN})
    firsthit_precompile_options(${target})
endfunction()

# firsthit_precompile_as(target other): what was precompiled for another target of the same options.
function(firsthit_precompile_as target other)
    target_precompile_headers(${target} REUSE_FROM ${other})
    firsthit_precompile_options(${target})
endfunction()

function(firsthit_precompile_options target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
        target_compile_options(${target} PRIVATE -fpch-preprocess) # ccache has to see what was precompiled
    endif()
endfunction()

# firsthit_part_of_programs(target): a library that only programs are linked with is compiled as they are, so
# that they can share what was precompiled. (The compiler refuses headers precompiled with -fPIC for -fPIE.)
function(firsthit_part_of_programs target)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${target} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIE})
endfunction()
