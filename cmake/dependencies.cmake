# Libraries, each with the Debian 12 package that has it.
function(firsthit_need name package)
    find_package(${name} ${ARGN} QUIET)
    if(NOT ${name}_FOUND)
        message(FATAL_ERROR "firsthit needs ${name}: apt-get install ${package}")
    endif()
    set(${name}_FOUND ${${name}_FOUND} PARENT_SCOPE)
    set(${name}_VERSION ${${name}_VERSION} PARENT_SCOPE)
endfunction()

find_package(Threads REQUIRED)
firsthit_need(glm libglm-dev)
firsthit_need(hwy libhwy-dev)
firsthit_need(PNG libpng-dev)
firsthit_need(OpenEXR libopenexr-dev)
firsthit_need(fmt libfmt-dev)

# stb comes as headers without a package file.
find_path(FIRSTHIT_STB_INCLUDE stb/stb_image.h)
if(NOT FIRSTHIT_STB_INCLUDE)
    message(FATAL_ERROR "firsthit needs stb: apt-get install libstb-dev")
endif()

# Debian's hwy package exports its target under this name only.
set(FIRSTHIT_PRIVATE_LIBRARIES Threads::Threads hwy::hwy PNG::PNG OpenEXR::OpenEXR fmt::fmt)
if(FIRSTHIT_BUILD_EMBREE)
    firsthit_need(embree libembree-dev 3)
    list(APPEND FIRSTHIT_PRIVATE_LIBRARIES embree)
else()
    message(STATUS "firsthit: without Embree (FIRSTHIT_BUILD_EMBREE=OFF)")
endif()
if(FIRSTHIT_BUILD_GL)
    list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}) # Findepoxy.cmake
    firsthit_need(epoxy libepoxy-dev)
    list(APPEND FIRSTHIT_PRIVATE_LIBRARIES epoxy::epoxy ${CMAKE_DL_LIBS})
else()
    message(STATUS "firsthit: without OpenGL (FIRSTHIT_BUILD_GL=OFF)")
endif()
