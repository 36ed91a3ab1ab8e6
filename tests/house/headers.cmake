# SPDX-License-Identifier: MIT
# Every header compiles alone, and twice. Each header has one unit, which the test builds. Units of headers that include
# Eigen, directly or through others, have it precompiled.
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
set(check ${CMAKE_CXX_COMPILER_LAUNCHER} ${CMAKE_CXX_COMPILER} -std=c++20 -I${EDGEWISE_INCLUDE} -isystem ${eigen})
file(CONFIGURE OUTPUT ${folder}/eigen.hpp CONTENT "#include <Eigen/Core>\n")
add_custom_command(OUTPUT ${folder}/eigen.hpp.gch DEPENDS ${folder}/eigen.hpp
    COMMAND ${check} -x c++-header ${folder}/eigen.hpp -o ${folder}/eigen.hpp.gch VERBATIM)

foreach(header IN LISTS headers)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} once REGEX "^#pragma once$")
    if(once STREQUAL "")
        message(FATAL_ERROR "house: ${header} lacks #pragma once")
    endif()
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes_${header} REGEX "^#include [<\"](Eigen|edgewise)/")
    list(TRANSFORM includes_${header} REPLACE "^#include .([^>\"]*).*" "\\1")
endforeach()

set(with_eigen Eigen/Core Eigen/Dense)  # names as they are included; each pass adds headers that include one of them
set(grows TRUE)
while(grows)
    set(grows FALSE)
    foreach(header IN LISTS headers)
        string(REPLACE edgewise/src/ "" name edgewise/${header})
        foreach(included IN LISTS includes_${header})
            if(included IN_LIST with_eigen AND NOT name IN_LIST with_eigen)
                list(APPEND with_eigen ${name})
                set(grows TRUE)
            endif()
        endforeach()
    endforeach()
endwhile()

set(units)
foreach(header IN LISTS headers)
    string(REPLACE edgewise/src/ "" name edgewise/${header})
    string(REPLACE / _ unit ${name})
    set(unit ${folder}/${unit})
    file(CONFIGURE OUTPUT ${unit}.cpp CONTENT "#include \"${name}\"\n#include \"${name}\"\n")
    set(precompiled)
    if(name IN_LIST with_eigen)
        set(precompiled -include ${folder}/eigen.hpp)
    endif()
    add_custom_command(OUTPUT ${unit}.o DEPENDS ${unit}.cpp ${folder}/eigen.hpp.gch DEPFILE ${unit}.d
        COMMAND ${check} ${precompiled} -MD -MF ${unit}.d -MT ${unit}.o -c ${unit}.cpp -o ${unit}.o
        COMMENT "header ${header}" VERBATIM)
    list(APPEND units ${unit}.o)
endforeach()
add_custom_target(house_headers DEPENDS ${units})
add_test(NAME house.headers_compile_alone
    COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --parallel 2 --target house_headers)
set_tests_properties(house.headers_compile_alone PROPERTIES TIMEOUT 900 PROCESSORS 2 RESOURCE_LOCK build_folder)
