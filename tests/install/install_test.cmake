# install_test.cmake - installs into an empty folder, builds the consumer and the examples against it, runs all.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGN}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK_FOLDER})
file(MAKE_DIRECTORY ${WORK_FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${WORK_FOLDER}/prefix)
# build_project(SOURCE BINARY): a project that finds the installed package.
function(build_project source binary)
    run(${CMAKE_COMMAND} -S ${source} -B ${binary} -G ${GENERATOR}
        -D CMAKE_CXX_COMPILER=${COMPILER}
        -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
        -D CMAKE_BUILD_TYPE=${BUILD_TYPE}
        -D CMAKE_CXX_FLAGS=${FLAGS}
        -D CMAKE_PREFIX_PATH=${WORK_FOLDER}/prefix)
    run(${CMAKE_COMMAND} --build ${binary})
endfunction()
build_project(${CONSUMER_FOLDER} ${WORK_FOLDER}/build)
run(${CMAKE_COMMAND} -E chdir ${WORK_FOLDER} ${WORK_FOLDER}/build/consumer)
if(NOT EXISTS ${WORK_FOLDER}/torus.png)
    message(FATAL_ERROR "the consumer wrote no torus.png")
endif()

# The same without CMake.
find_program(PKG_CONFIG pkg-config)
file(GLOB_RECURSE pc ${WORK_FOLDER}/prefix/firsthit.pc)
if(PKG_CONFIG)
    cmake_path(GET pc PARENT_PATH pc_folder)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${pc_folder}
        ${PKG_CONFIG} --cflags --libs firsthit
        OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(words UNIX_COMMAND "${words}")
    separate_arguments(flags UNIX_COMMAND "${FLAGS}")
    file(REMOVE ${WORK_FOLDER}/torus.png)
    run(${COMPILER} -std=c++20 ${flags} ${CONSUMER_FOLDER}/main.cpp -o ${WORK_FOLDER}/by_pkg_config ${words})
    run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${pc_folder}/.. ${CMAKE_COMMAND} -E chdir ${WORK_FOLDER}
        ${WORK_FOLDER}/by_pkg_config)
    if(NOT EXISTS ${WORK_FOLDER}/torus.png)
        message(FATAL_ERROR "the consumer built by pkg-config wrote no torus.png")
    endif()
else()
    message(STATUS "skipped: pkg-config is not here")
endif()

build_project(${EXAMPLES_FOLDER} ${WORK_FOLDER}/examples)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK_FOLDER}/examples --output-on-failure --no-tests=error)
if(PROGRAM)
    run(${WORK_FOLDER}/prefix/bin/${PROGRAM} --version)
    foreach(file man/man1/firsthit.1 bash-completion/completions/firsthit zsh/vendor-completions/_firsthit
            fish/vendor_completions.d/firsthit.fish)
        if(NOT EXISTS ${WORK_FOLDER}/prefix/share/${file})
            message(FATAL_ERROR "share/${file} is not installed")
        endif()
    endforeach()
endif()
