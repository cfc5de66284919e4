# embed_texts.cmake - embeds text files in a program: a function of all of them, by name.
#
#   firsthit_embed_texts(target function ROOT folder NAMES name... HEADER header NAMESPACE namespace TYPE type)
#
# The header, which is ours, declares
#   struct TYPE { std::string_view name, text; };
#   std::span<const TYPE> function();
# in NAMESPACE. The function gives the texts in the order of NAMES, which are relative to ROOT; its definition is
# written when one of them changes, by this file run as a script.
if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(FIRSTHIT_EMBED_TEXTS ${CMAKE_CURRENT_LIST_FILE})
    function(firsthit_embed_texts target function)
        cmake_parse_arguments(ARG "" "ROOT;HEADER;NAMESPACE;TYPE" "NAMES" ${ARGN})
        list(TRANSFORM ARG_NAMES PREPEND ${ARG_ROOT}/ OUTPUT_VARIABLE files)
        list(JOIN ARG_NAMES "|" names)
        set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
        add_custom_command(OUTPUT ${output}
            COMMAND ${CMAKE_COMMAND} -D ROOT=${ARG_ROOT} -D NAMES=${names} -D OUTPUT=${output}
                -D HEADER=${ARG_HEADER} -D NAMESPACE=${ARG_NAMESPACE} -D TYPE=${ARG_TYPE}
                -D FUNCTION=${function} -P ${FIRSTHIT_EMBED_TEXTS}
            DEPENDS ${files} ${FIRSTHIT_EMBED_TEXTS}
            COMMENT "Embedding ${function}" VERBATIM)
        # A target of the caller's folder, because rules are not seen from that of the target.
        add_custom_target(${target}_${function} DEPENDS ${output})
        add_dependencies(${target} ${target}_${function})
        target_sources(${target} PRIVATE ${output})
    endfunction()
    return()
endif()

string(REPLACE "|" ";" names "${NAMES}")
set(rows "")
foreach(name IN LISTS names)
    file(READ "${ROOT}/${name}" text)
    string(APPEND rows "    {\"${name}\", R\"firsthit(${text})firsthit\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Written by cmake/embed_texts.cmake.
#include \"${HEADER}\"

namespace ${NAMESPACE} {
namespace {

constexpr ${TYPE} kTexts[] = {
${rows}};

} // namespace

std::span<const ${TYPE}> ${FUNCTION}()
{
    return kTexts;
}

} // namespace ${NAMESPACE}
")
