# The target docs: the reference of the public headers, in docs/html/ of the build's folder.
find_program(FIRSTHIT_DOXYGEN doxygen)
mark_as_advanced(FIRSTHIT_DOXYGEN)
if(NOT FIRSTHIT_DOXYGEN)
    message(STATUS "firsthit: without the target docs: apt-get install doxygen")
    return()
endif()
add_custom_target(docs
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/docs
    COMMAND ${CMAKE_COMMAND} -E env FIRSTHIT_DOCS_FOLDER=${PROJECT_BINARY_DIR}/docs
        FIRSTHIT_DOCS_WARN_AS_ERROR=NO FIRSTHIT_VERSION=${PROJECT_VERSION}
        ${FIRSTHIT_DOXYGEN} docs/reference/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Reference: ${PROJECT_BINARY_DIR}/docs/html/index.html" VERBATIM)
