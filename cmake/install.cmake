# What is installed, in two components: `program` (the program, its manual and completions, a shared library where
# that is built) and `development` (the headers, a static library, a package config, so that
# find_package(firsthit) gives firsthit::firsthit, and a pkg-config file).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_target_property(library_type firsthit TYPE)
set(FIRSTHIT_IS_SHARED OFF)
if(library_type STREQUAL SHARED_LIBRARY)
    set(FIRSTHIT_IS_SHARED ON)
endif()
set_target_properties(firsthit PROPERTIES
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    DEFINE_SYMBOL "") # both kinds of library are compiled alike

install(TARGETS firsthit EXPORT firsthit-targets
    LIBRARY COMPONENT program NAMELINK_COMPONENT development
    RUNTIME COMPONENT program
    ARCHIVE COMPONENT development)
install(DIRECTORY include/firsthit DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
if(FIRSTHIT_BUILD_APPS)
    include(cmake/manual.cmake)
    install(TARGETS firsthit_program RUNTIME COMPONENT program)
    if(FIRSTHIT_IS_SHARED)
        file(RELATIVE_PATH library_folder
            ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
        set_target_properties(firsthit_program PROPERTIES INSTALL_RPATH "$ORIGIN/${library_folder}")
    endif()
    install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
endif()

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/firsthit)
install(EXPORT firsthit-targets NAMESPACE firsthit:: DESTINATION ${config_folder} COMPONENT development)
configure_package_config_file(cmake/firsthit-config.cmake.in firsthit-config.cmake
    INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(firsthit-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/firsthit-config.cmake
    ${PROJECT_BINARY_DIR}/firsthit-config-version.cmake
    DESTINATION ${config_folder} COMPONENT development)
if(NOT FIRSTHIT_IS_SHARED)
    if(webp_FOUND)
        install(FILES cmake/Findwebp.cmake DESTINATION ${config_folder} COMPONENT development)
    endif()
    if(FIRSTHIT_BUILD_GL)
        install(FILES cmake/Findepoxy.cmake DESTINATION ${config_folder} COMPONENT development)
    endif()
endif()

include(cmake/pkg_config.cmake)
include(cmake/package.cmake)
