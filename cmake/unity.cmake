# unity.cmake - what a unity build (CMAKE_UNITY_BUILD: several files compiled as one) has to leave alone.
#
# Kernel files include themselves once for each instruction set (src/base/simd.h); each stays a unit of its own.
function(firsthit_keep_kernels_alone target)
    if(NOT CMAKE_UNITY_BUILD)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        if(NOT EXISTS ${source}) # written by the build
            continue()
        endif()
        file(STRINGS ${source} line REGEX "^#define HWY_TARGET_INCLUDE" LIMIT_COUNT 1)
        if(line)
            set_source_files_properties(${source} TARGET_DIRECTORY ${target}
                PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        endif()
    endforeach()
endfunction()
