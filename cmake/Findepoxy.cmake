# Findepoxy.cmake - the target epoxy::epoxy. libepoxy comes with a pkg-config file only; installed
# beside firsthit's package config, for those who link the static library.
find_path(EPOXY_INCLUDE epoxy/egl.h)
find_library(EPOXY_LIBRARY epoxy)
mark_as_advanced(EPOXY_INCLUDE EPOXY_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(epoxy REQUIRED_VARS EPOXY_LIBRARY EPOXY_INCLUDE)
if(epoxy_FOUND AND NOT TARGET epoxy::epoxy)
    add_library(epoxy::epoxy UNKNOWN IMPORTED)
    set_target_properties(epoxy::epoxy PROPERTIES
        IMPORTED_LOCATION "${EPOXY_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${EPOXY_INCLUDE}")
endif()
