# pkg_config.cmake - firsthit.pc, for those who build without CMake. A static library is linked with all that it uses
# itself; a shared one asks for nothing but what the headers need.
set(FIRSTHIT_PC_REQUIRES "glm")
set(FIRSTHIT_PC_LIBS "-lfirsthit")
if(NOT FIRSTHIT_IS_SHARED)
    string(APPEND FIRSTHIT_PC_REQUIRES " libhwy libpng OpenEXR fmt")
    foreach(pair assimp:assimp draco:draco JPEG:libjpeg webp:libwebp)
        string(REPLACE ":" ";" pair ${pair})
        list(GET pair 0 library)
        list(GET pair 1 package)
        if(${library}_FOUND)
            string(APPEND FIRSTHIT_PC_REQUIRES " ${package}")
        endif()
    endforeach()
    if(FIRSTHIT_BUILD_GL)
        string(APPEND FIRSTHIT_PC_REQUIRES " epoxy")
    endif()
    if(meshoptimizer_FOUND) # it and Embree have no files of pkg-config
        string(APPEND FIRSTHIT_PC_LIBS " -lmeshoptimizer")
    endif()
    if(FIRSTHIT_BUILD_EMBREE)
        string(APPEND FIRSTHIT_PC_LIBS " -lembree3")
    endif()
    string(APPEND FIRSTHIT_PC_LIBS " -pthread -ldl")
endif()
# Paths are told from where the file lies: what is installed may be moved.
file(RELATIVE_PATH FIRSTHIT_PC_TO_PREFIX
    ${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" FIRSTHIT_PC_TO_PREFIX "${FIRSTHIT_PC_TO_PREFIX}")
configure_file(cmake/firsthit.pc.in firsthit.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/firsthit.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
