# SPDX-License-Identifier: MIT
# clang-format and clang-tidy, both of version 14: other versions format differently and have other checks.
function(find_clang_tool TOOL RESULT)
    find_program(${RESULT} NAMES ${TOOL}-14 ${TOOL})
    if(${RESULT})
        execute_process(COMMAND ${${RESULT}} --version OUTPUT_VARIABLE version ERROR_QUIET)
        if(version MATCHES "version 14\\.")
            return()
        endif()
    endif()
    message(STATUS "house: ${TOOL} 14 not found, so no test runs it (Debian: ${TOOL}-14)")
    set(${RESULT} "" PARENT_SCOPE)
endfunction()

find_clang_tool(clang-format HOUSE_CLANG_FORMAT)
if(HOUSE_CLANG_FORMAT)
    add_test(NAME house.format COMMAND sh -c
        "find src layouts probes reports tests examples -name '*.[ch]pp' | xargs ${HOUSE_CLANG_FORMAT} --style=file --dry-run -Werror"
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(house.format PROPERTIES TIMEOUT 120)
endif()

# A few units that together include most of the project, because all units take many minutes. Each with the folders that it
# may include.
find_clang_tool(clang-tidy HOUSE_CLANG_TIDY)
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
function(house_tidy UNIT)
    if(NOT HOUSE_CLANG_TIDY)
        return()
    endif()
    get_filename_component(name ${UNIT} NAME_WE)
    add_test(NAME house.tidy_${name} COMMAND ${HOUSE_CLANG_TIDY} --quiet --config-file=${PROJECT_SOURCE_DIR}/.clang-tidy ${UNIT}
        -- -std=c++20 -I${EDGEWISE_INCLUDE} -I${PROJECT_BINARY_DIR}/registry -isystem ${eigen})
    set_tests_properties(house.tidy_${name} PROPERTIES TIMEOUT 600)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
    edgewise_inputs(house.tidy_${name} ${UNIT} ${PROJECT_SOURCE_DIR}/.clang-tidy ${ARGN})
endfunction()
house_tidy(${PROJECT_SOURCE_DIR}/src/edgewise/geometry/hull.cpp src/edgewise/geometry)
house_tidy(${PROJECT_SOURCE_DIR}/src/edgewise/truth/exact_distance.cpp src/edgewise/geometry src/edgewise/truth)
house_tidy(${PROJECT_SOURCE_DIR}/src/edgewise/sweep/run.cpp src/edgewise)
house_tidy(${PROJECT_SOURCE_DIR}/reports/page/page.cpp src/edgewise reports)
get_property(table_types GLOBAL PROPERTY EDGEWISE_TABLE_TYPES)
list(GET table_types 0 first)
house_tidy(${PROJECT_BINARY_DIR}/registry/${first}.cpp src/edgewise layouts probes)

# The opposite option is among the options of all targets.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_test(NAME house.query_loop_flags COMMAND ${CMAKE_COMMAND} -D COMMANDS=${PROJECT_BINARY_DIR}/compile_commands.json
        -D OPTION=-ftree-slp-vectorize -D OPPOSITE=-fno-tree-slp-vectorize -P ${CMAKE_CURRENT_SOURCE_DIR}/check_query_loop_flags.cmake)
endif()

# GCC may fuse operations that -ffp-contract=off keeps separate (cmake/options.cmake).
find_program(HOUSE_OBJDUMP objdump)
if(HOUSE_OBJDUMP AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    add_test(NAME house.no_contraction COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/check_contraction.sh ${HOUSE_OBJDUMP}
        $<TARGET_FILE:edgewise_measuring>)
    set_tests_properties(house.no_contraction PROPERTIES TIMEOUT 120)
    edgewise_inputs(house.no_contraction ${EDGEWISE_MEASURING_PROGRAM} ${CMAKE_CURRENT_SOURCE_DIR}/check_contraction.sh)
endif()
