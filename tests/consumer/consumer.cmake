# SPDX-License-Identifier: MIT
# consumer.cmake with SOURCE, BUILD, SCRATCH, COMPILER, GENERATOR: installs the package, moves it, checks that it has
# no forbidden words, and builds README's example, the installed one and one with threads (without machine tuning and
# outside flags; also with clang++ if there is one). It compares their output with README. Then it builds the
# layout lock of a user's structure, with edgewise::measure alone: it must pass with the unchanged structure, and fail with
# the differences if a member is added.
cmake_minimum_required(VERSION 3.25)
set(ENV{CXXFLAGS} "")
set(ENV{LDFLAGS} "")
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

# Exported files must work on every machine and without the build folder.
function(check_exported_files PREFIX)
    file(GLOB_RECURSE files ${PREFIX}/*.cmake)
    list(LENGTH files count)
    if(count LESS 3)
        message(FATAL_ERROR "only ${count} CMake files were installed")
    endif()
    foreach(file IN LISTS files)
        file(READ ${file} text)
        foreach(word -march -mtune -fsanitize TBB ${BUILD} ${SOURCE})
            string(FIND "${text}" "${word}" at)
            if(NOT at EQUAL -1)
                message(SEND_ERROR "${file} names ${word}")
            endif()
        endforeach()
    endforeach()
endfunction()

function(check_installed_headers PREFIX)
    file(GLOB_RECURSE headers ${PREFIX}/include/*.hpp)
    list(LENGTH headers count)
    if(count LESS 20)
        message(FATAL_ERROR "only ${count} headers were installed")
    endif()
    foreach(header IN LISTS headers)
        file(STRINGS ${header} threaded REGEX "^#include <tbb/")
        if(threaded AND NOT header MATCHES "/parallel_batch.hpp$")
            message(SEND_ERROR "${header} includes TBB, which the package does not bring")
        endif()
        file(STRINGS ${header} lines REGEX "^#include \"edgewise/")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" name "${line}")
            if(NOT EXISTS ${PREFIX}/include/${name})
                message(SEND_ERROR "${header} includes ${name}, which is not installed")
            endif()
        endforeach()
    endforeach()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run("installing" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/installed)
set(prefix "${SCRATCH}/moved elsewhere")
file(RENAME ${SCRATCH}/installed ${prefix})
check_exported_files(${prefix})
check_installed_headers(${prefix})

# build_project(NAME COMPILER FOLDER WORDS DEFINITION...): builds tests/consumer/NAME with the package. The compiler's
# commands must not have any of the words.
function(build_project NAME COMPILER FOLDER WORDS)
    run("configuring ${NAME}" ${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer/${NAME} -B ${FOLDER} -G ${GENERATOR}
        -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${prefix} ${ARGN})
    run("building ${NAME} with ${COMPILER}" ${CMAKE_COMMAND} --build ${FOLDER} --verbose)
    foreach(word IN LISTS WORDS)
        string(FIND "${output}" "${word}" at)
        if(NOT at EQUAL -1)
            message(SEND_ERROR "${NAME} was compiled with ${word}:\n${output}")
        endif()
    endforeach()
endfunction()

# Builds all programs with one compiler, and compares their output.
function(check_consumer COMPILER FOLDER)
    build_project(project ${COMPILER} ${FOLDER} "-march;${BUILD}/include;${SOURCE}/src" -D EXAMPLE=${SCRATCH}/example.cpp
        -D EXAMPLES=${examples})
    expect_output("README's example" ${FOLDER}/consumer "${expected}")
    set(built ${FOLDER}/examples)
    expect_output("own_shape.cpp" ${built}/own_shape
        "separated 2 along 1 0 0;separated 0.5 along 1 0 0;overlapping 0.25 along 1 0 0")
    expect_output("two_layouts.cpp" ${built}/two_layouts
        "aos 2912 bytes, distance 1.000000;lean 129 bytes, distance 1.000000")
    expect_output("penetration.cpp" ${built}/penetration "0.25 deep;0 deep")
    expect_output("nearer_than.cpp" ${built}/nearer_than "7 of 128 frames nearer than 0.5, 5 queries")
    expect_output("many_scales.cpp" ${built}/many_scales "separated 1.5;separated 0.5;overlapping 0")
    expect_output("query_batch.cpp" ${built}/query_batch "sum of distances 500500, as by single queries")
    expect_output("many_pairs.cpp" ${built}/many_pairs "500500 500500")
endfunction()

# Runs the project's ctest: EXPECTED is its exit code; every further word must occur in its output.
function(check_lock COMPILER FOLDER ADD_A_MEMBER EXPECTED)
    build_project(layout_lock ${COMPILER} ${FOLDER} "${BUILD}/libedgewise;${SOURCE}/src;Eigen;eigen;qhull"
        -D ADD_A_MEMBER=${ADD_A_MEMBER} -D EXAMPLES=${examples})
    execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${FOLDER} --verbose RESULT_VARIABLE result
        OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL EXPECTED)
        message(FATAL_ERROR "ctest of the lock ended with ${result}, not ${EXPECTED}:\n${output}")
    endif()
    foreach(line IN LISTS ARGN)
        string(FIND "${output}" "${line}" at)
        if(at EQUAL -1)
            message(FATAL_ERROR "ctest of the lock does not say '${line}':\n${output}")
        endif()
    endforeach()
    message("the lock of kd_tree with ADD_A_MEMBER=${ADD_A_MEMBER}: ctest ends with ${result} and says ${ARGN}")
endfunction()

# ctest ends with 8 when a test failed. The change is an undeclared member of 4 bytes, in 4000 nodes.
function(check_locks COMPILER FOLDER)
    check_lock(${COMPILER} ${FOLDER} OFF 0 "kd_tree.lock.json: passed")
    check_lock(${COMPILER} ${FOLDER} ON 8 "bytes.nodes.padding: was 0, is 16000" "lines_per_query: was ")
endfunction()

# The example in Python prints one figure of a store's two cells.
function(check_python)
    find_program(PYTHON python3)
    if(NOT PYTHON)
        message("no python3 here: read_store.py is not tried (Debian: python3)")
        return()
    endif()
    run("a small sweep" ${BUILD}/edgewise sweep --scenes cold --shape cube8 --layouts lean_f32,aos_f64 --algorithms vclip
        --queries 100 --checked 20 --rounds 1 --no-report --store ${SCRATCH}/s.db)
    run("read_store.py" ${PYTHON} ${examples}/read_store.py ${SCRATCH}/s.db bytes.total_bytes_per_edge)
    if(NOT output MATCHES "^cold cube8 vclip lean_f32 [0-9.]+ [^\n]*\ncold cube8 vclip aos_f64 [0-9.]+ [^\n]* ########################################\n$")
        message(FATAL_ERROR "read_store.py prints:\n${output}")
    endif()
    message("read_store.py prints:\n${output}")
endfunction()

read_example(${SOURCE}/README.md example expected)
file(WRITE ${SCRATCH}/example.cpp "${example}")
foreach(document README.md own_shape.cpp kd_tree.cpp read_store.py)
    file(GLOB_RECURSE found ${prefix}/share/doc/*${document})
    if(NOT found)
        message(SEND_ERROR "${document} was not installed")
    endif()
endforeach()
file(GLOB examples ${prefix}/share/doc/*/examples)
check_consumer(${COMPILER} ${SCRATCH}/build)
check_locks(${COMPILER} ${SCRATCH}/lock)
check_python()
find_program(OTHER NAMES clang++ clang++-14 clang++-15 clang++-16)
if(OTHER)
    check_consumer(${OTHER} ${SCRATCH}/build-other)
    check_locks(${OTHER} ${SCRATCH}/lock-other)
endif()
