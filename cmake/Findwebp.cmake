# Findwebp.cmake - the target webp::webp. libwebp comes with a pkg-config file only; installed beside
# firsthit's package config, for those who link the static library.
find_path(WEBP_INCLUDE webp/decode.h)
find_library(WEBP_LIBRARY webp)
mark_as_advanced(WEBP_INCLUDE WEBP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(webp REQUIRED_VARS WEBP_LIBRARY WEBP_INCLUDE)
if(webp_FOUND AND NOT TARGET webp::webp)
    add_library(webp::webp UNKNOWN IMPORTED)
    set_target_properties(webp::webp PROPERTIES
        IMPORTED_LOCATION "${WEBP_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${WEBP_INCLUDE}")
endif()
