# SPDX-License-Identifier: MIT
# Every header compiles alone, and twice. One unit a header, checked but not compiled to code, by a target that only
# the test asks for; a header that did not change, nor what it includes, is not checked again. A header that its own
# source includes before all others has been compiled alone by the build. Those that include Eigen have it precompiled.
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
set(check ${CMAKE_CXX_COMPILER} -std=c++20 -I${EDGEWISE_INCLUDE} -isystem ${eigen})
file(CONFIGURE OUTPUT ${folder}/eigen.hpp CONTENT "#include <Eigen/Core>\n")
add_custom_command(OUTPUT ${folder}/eigen.hpp.gch DEPENDS ${folder}/eigen.hpp
    COMMAND ${check} -x c++-header ${folder}/eigen.hpp -o ${folder}/eigen.hpp.gch VERBATIM)

# includes_eigen: the headers that do, themselves or through others.
set(includes_eigen)
set(before -1)
list(LENGTH includes_eigen now)
foreach(header IN LISTS headers)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} included REGEX "^#include [<\"](Eigen|edgewise)/")
    string(REGEX REPLACE "^src/edgewise/" "" name ${header})
    set(includes_of_${name} "${included}")
    list(APPEND names ${name})
endforeach()
while(NOT before EQUAL now)
    set(before ${now})
    foreach(name IN LISTS names)
        if(name IN_LIST includes_eigen)
            continue()
        endif()
        foreach(line IN LISTS includes_of_${name})
            string(REGEX REPLACE "^#include .(edgewise/)?([^>\"]*).*" "\\2" included "${line}")
            if(included MATCHES "^Eigen/" OR included IN_LIST includes_eigen)
                list(APPEND includes_eigen ${name})
                break()
            endif()
        endforeach()
    endforeach()
    list(LENGTH includes_eigen now)
endwhile()

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
    set(precompiled)
    if(name IN_LIST includes_eigen)
        set(precompiled -include ${folder}/eigen.hpp)
    endif()
    add_custom_command(OUTPUT ${unit}.checked DEPENDS ${unit}.cpp ${folder}/eigen.hpp.gch DEPFILE ${unit}.d
        COMMAND ${check} -fsyntax-only ${precompiled} -MD -MF ${unit}.d -MT ${unit}.checked ${unit}.cpp
        COMMAND ${CMAKE_COMMAND} -E touch ${unit}.checked
        COMMENT "header ${header}" VERBATIM)
    list(APPEND checked ${unit}.checked)
endforeach()
add_custom_target(house_headers DEPENDS ${checked})
add_test(NAME house.headers_compile_alone
    COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target house_headers --parallel 2)
set_tests_properties(house.headers_compile_alone PROPERTIES TIMEOUT 900 PROCESSORS 2 RESOURCE_LOCK build_folder)
