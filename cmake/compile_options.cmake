# Options of every target of ours. Contraction is off because the exactness proofs count roundings.
function(firsthit_compile_options target)
    target_compile_options(${target} PRIVATE
        -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
    if(FIRSTHIT_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()
