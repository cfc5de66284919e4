# Options of every target of ours. Contraction is off because the exactness proofs count roundings.
function(firsthit_compile_options target)
    target_compile_options(${target} PRIVATE
        -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # GCC 12 loses the rounding of double(float(x)) in pairs that it puts into one register.
        target_compile_options(${target} PRIVATE -fno-tree-slp-vectorize)
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
        # GCC 12 takes `"text" + string` for overlapping memory at -O3 (its bug 105651), and the copy of a literal
        # into a new std::string for one beyond its end; the sanitizers look for the real ones.
        target_compile_options(${target} PRIVATE -Wno-restrict -Wno-array-bounds)
    endif()
    if(FIRSTHIT_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()

# For tests: compiling them is most of their cost. Not for the program: of an inline function that the library has
# too, the linker keeps one copy, and that may be the program's.
function(firsthit_optimise_less target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
endfunction()
