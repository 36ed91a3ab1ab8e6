# SPDX-License-Identifier: MIT
# Every header compiles alone, and twice. One unit a header, checked but not compiled to code, by a target that only
# the test asks for; a header that did not change, nor what it includes, is not checked again. A header that its own
# source includes before all others has been compiled alone by the build.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src/edgewise/*.hpp
    ${PROJECT_SOURCE_DIR}/layouts/*.hpp ${PROJECT_SOURCE_DIR}/probes/*.hpp ${PROJECT_SOURCE_DIR}/reports/*.hpp)
list(LENGTH headers count)
if(count LESS 50)
    message(FATAL_ERROR "house: only ${count} headers found below ${PROJECT_SOURCE_DIR}")
endif()

set(folder ${CMAKE_CURRENT_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${folder})
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
foreach(header IN LISTS headers)
    string(REGEX REPLACE "^src/edgewise/" "" name ${header})
    string(REGEX REPLACE "hpp$" "cpp" source ${PROJECT_SOURCE_DIR}/${header})
    set(first "")
    if(EXISTS ${source})
        file(STRINGS ${source} first REGEX "^#include" LIMIT_COUNT 1)
    endif()
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} once REGEX "^#pragma once$")
    if(once STREQUAL "")
        message(FATAL_ERROR "house: ${header} lacks #pragma once")
    endif()
    if(first STREQUAL "#include \"edgewise/${name}\"")
        continue()
    endif()
    string(REPLACE / _ unit ${name})
    set(unit ${folder}/${unit})
    file(CONFIGURE OUTPUT ${unit}.cpp CONTENT "#include \"edgewise/${name}\"\n#include \"edgewise/${name}\"\n")
    add_custom_command(OUTPUT ${unit}.checked DEPENDS ${unit}.cpp DEPFILE ${unit}.d
        COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -I${EDGEWISE_INCLUDE} -isystem ${eigen}
                -MD -MF ${unit}.d -MT ${unit}.checked ${unit}.cpp
        COMMAND ${CMAKE_COMMAND} -E touch ${unit}.checked
        COMMENT "header ${header}" VERBATIM)
    list(APPEND checked ${unit}.checked)
endforeach()
add_custom_target(house_headers DEPENDS ${checked})
add_test(NAME house.headers_compile_alone
    COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target house_headers --parallel 2)
set_tests_properties(house.headers_compile_alone PROPERTIES TIMEOUT 900 PROCESSORS 2 RESOURCE_LOCK build_folder)
