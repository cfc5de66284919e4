# manual.cmake - the manual and the completions of shells, which the program itself prints when it is built.
if(CMAKE_CROSSCOMPILING)
    message(STATUS "firsthit: without manual and completions, which the program prints: it is for another machine")
    return()
endif()
set(manual_folder ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${manual_folder})
set(manual_files "")
# firsthit_printed(FILE DESTINATION WORD...): what the program prints for some words, as an installed file.
function(firsthit_printed file destination)
    add_custom_command(OUTPUT ${manual_folder}/${file}
        COMMAND firsthit_program ${ARGN} > ${manual_folder}/${file}
        DEPENDS firsthit_program VERBATIM
        COMMENT "Printing ${file}")
    # A build of the library alone has none.
    install(FILES ${manual_folder}/${file} DESTINATION ${destination} COMPONENT program OPTIONAL)
    set(manual_files ${manual_files} ${manual_folder}/${file} PARENT_SCOPE)
endfunction()
firsthit_printed(firsthit.1 ${CMAKE_INSTALL_MANDIR}/man1 man)
firsthit_printed(firsthit ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completion bash)
firsthit_printed(_firsthit ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions completion zsh)
firsthit_printed(firsthit.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d completion fish)
add_custom_target(firsthit_manual ALL DEPENDS ${manual_files})
