# SPDX-License-Identifier: MIT
# Every header compiles alone, and twice. One unit a header, built by the test: those that changed since the revision at
# which this test last passed here, or in the last commits of a fresh clone, and those that no longer include, through
# others, all that they did. With EDGEWISE_FULL_TESTS all of them. Headers that include Eigen have it precompiled.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src/edgewise/*.hpp
    ${PROJECT_SOURCE_DIR}/layouts/*.hpp ${PROJECT_SOURCE_DIR}/probes/*.hpp ${PROJECT_SOURCE_DIR}/reports/*.hpp)
# Adapters need the libraries that they adapt; their modules compile them.
list(FILTER headers EXCLUDE REGEX "peers/adapters/")
list(LENGTH headers count)
if(count LESS 50)
    message(FATAL_ERROR "house: only ${count} headers found below ${PROJECT_SOURCE_DIR}")
endif()

set(folder ${CMAKE_CURRENT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${folder})
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(check ${CMAKE_CXX_COMPILER_LAUNCHER} ${CMAKE_CXX_COMPILER} -std=c++20 -I${EDGEWISE_INCLUDE} -I${PROJECT_BINARY_DIR}/registry
    -isystem ${eigen})
file(CONFIGURE OUTPUT ${folder}/eigen.hpp CONTENT "#include <Eigen/Core>\n")
add_custom_command(OUTPUT ${folder}/eigen.hpp.gch DEPENDS ${folder}/eigen.hpp
    COMMAND ${check} -x c++-header ${folder}/eigen.hpp -o ${folder}/eigen.hpp.gch VERBATIM)

include(${CMAKE_CURRENT_SOURCE_DIR}/include_graph.cmake)
edgewise_include_lines(${PROJECT_SOURCE_DIR} "${headers}" lines)
edgewise_read_includes(now "${lines}")

set(units)
foreach(header IN LISTS headers)
    edgewise_header_name(${header} name)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} once REGEX "^#pragma once$")
    if(once STREQUAL "")
        message(FATAL_ERROR "house: ${header} lacks #pragma once")
    endif()
    string(REPLACE / _ unit ${name})
    set(unit ${folder}/${unit})
    file(CONFIGURE OUTPUT ${unit}.cpp CONTENT "#include \"edgewise/${name}\"\n#include \"edgewise/${name}\"\n")
    set(precompiled)
    edgewise_included(now ${name} included)
    if("Eigen/Core" IN_LIST included OR "Eigen/Dense" IN_LIST included)
        set(precompiled -include ${folder}/eigen.hpp)
    endif()
    add_custom_command(OUTPUT ${unit}.o DEPENDS ${unit}.cpp ${folder}/eigen.hpp.gch DEPFILE ${unit}.d
        COMMAND ${check} ${precompiled} -MD -MF ${unit}.d -MT ${unit}.o -c ${unit}.cpp -o ${unit}.o
        COMMENT "header ${header}" VERBATIM)
    list(APPEND units ${unit}.o)
endforeach()
add_custom_target(house_headers DEPENDS ${units})
list(JOIN headers "\n" headers)
file(CONFIGURE OUTPUT ${folder}/headers.txt CONTENT "${headers}\n")
add_test(NAME house.headers_compile_alone
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D BUILD=${PROJECT_BINARY_DIR} -D FOLDER=${folder}
            -D ALL=${EDGEWISE_FULL_TESTS} -P ${CMAKE_CURRENT_SOURCE_DIR}/check_headers.cmake)
set_tests_properties(house.headers_compile_alone PROPERTIES TIMEOUT 900 PROCESSORS 2 COST 200 RESOURCE_LOCK build_folder)
