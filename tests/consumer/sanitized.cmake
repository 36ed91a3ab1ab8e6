# SPDX-License-Identifier: MIT
# Compiles and runs programs under sanitizers, as a user's CI does: with each of COMPILERS, LEVELS and SANITIZERS,
# sanitized/queries.cpp with POSES poses on 8 and on 400 vertices, and the EXAMPLES of examples/ (example: README's).
# A report fails, and so do different answers of table types.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
set(ENV{TSAN_OPTIONS} suppressions=${CMAKE_CURRENT_LIST_DIR}/sanitized/tbb.supp)

# Sets SECONDS to the wall time of the compiler.
function(compile SOURCE_FILE)
    string(TIMESTAMP started %s)
    run("compiling ${SOURCE_FILE} with ${build}" ${compiler} -std=c++20 ${level} -g1 -ffp-contract=off
        -fsanitize=${sanitizer} -fno-sanitize-recover=all -I${SOURCE}/src -isystem ${EIGEN} ${SOURCE_FILE}
        ${LIBRARY} -lqhull_r -ltbb -o ${SCRATCH}/program)
    string(TIMESTAMP compiled %s)
    math(EXPR seconds "${compiled} - ${started}")
    set(SECONDS ${seconds} PARENT_SCOPE)
endfunction()

function(check_build)
    set(build "${compiler} ${level} -fsanitize=${sanitizer}")
    compile(${SOURCE}/tests/consumer/sanitized/queries.cpp)
    foreach(vertices 8 400)
        run("${build}, ${vertices} vertices" ${SCRATCH}/program ${vertices} ${POSES})
    endforeach()
    set(times "queries ${SECONDS} s")
    foreach(example IN LISTS EXAMPLES)
        set(source ${SOURCE}/examples/${example}.cpp)
        if(example STREQUAL "example")
            read_example(${SOURCE}/README.md text expected)
            set(source ${SCRATCH}/example.cpp)
            file(WRITE ${source} "${text}")
        endif()
        compile(${source})
        run("${build}, ${example}" ${SCRATCH}/program)
        string(APPEND times ", ${example} ${SECONDS} s")
    endforeach()
    message(STATUS "${build}: no report; compiled in: ${times}")
endfunction()

foreach(compiler IN LISTS COMPILERS)
    foreach(level IN LISTS LEVELS)
        foreach(sanitizer IN LISTS SANITIZERS)
            check_build()
        endforeach()
    endforeach()
endforeach()
