# What is installed: the library, its public headers, the program, and a package config, so that
# find_package(firsthit) gives firsthit::firsthit.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS firsthit EXPORT firsthit-targets)
install(DIRECTORY include/firsthit DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(FIRSTHIT_BUILD_APPS)
    install(TARGETS firsthit_program)
endif()

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/firsthit)
install(EXPORT firsthit-targets NAMESPACE firsthit:: DESTINATION ${config_folder})
configure_package_config_file(cmake/firsthit-config.cmake.in firsthit-config.cmake
    INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(firsthit-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/firsthit-config.cmake
    ${PROJECT_BINARY_DIR}/firsthit-config-version.cmake
    DESTINATION ${config_folder})
if(FIRSTHIT_BUILD_GL)
    install(FILES cmake/Findepoxy.cmake DESTINATION ${config_folder})
endif()
