# SPDX-License-Identifier: MIT
# The library's headers give no warnings if an engine includes them by -I, as part of its own tree. The test checks the syntax
# of every layout with every algorithm, with the warnings that engines turn into errors. It also uses clang++ if there is
# one, because it finds other conversions.
file(GLOB layouts CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/layouts ${PROJECT_SOURCE_DIR}/layouts/*.hpp)
list(LENGTH layouts count)
if(count LESS 20)
    message(FATAL_ERROR "house: only ${count} layouts found below ${PROJECT_SOURCE_DIR}/layouts")
endif()
set(INCLUDES)
set(USES)
foreach(layout IN LISTS layouts)
    string(REPLACE ".hpp" "" name ${layout})
    string(APPEND INCLUDES "#include \"edgewise/layouts/${layout}\"\n")
    foreach(precision f32 mixed)
        string(APPEND USES "    use<${name}<${precision}>>(body);\n")
    endforeach()
endforeach()
set(unit ${CMAKE_CURRENT_BINARY_DIR}/use_layouts.cpp)
configure_file(use_layouts.cpp.in ${unit} @ONLY)

set(library layouts src/edgewise/geometry src/edgewise/table src/edgewise/layout_parts src/edgewise/algorithms)
list(TRANSFORM library PREPEND ${PROJECT_SOURCE_DIR}/)
list(APPEND library ${CMAKE_CURRENT_SOURCE_DIR} ${unit})
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
find_program(HOUSE_CLANG NAMES clang++ clang++-14 clang++-15 clang++-16)
foreach(compiler ${CMAKE_CXX_COMPILER} ${HOUSE_CLANG})
    get_filename_component(name ${compiler} NAME)
    # The build warns of all but -Wsign-conversion with the first compiler, which therefore has this test in tests/run full.
    if(EDGEWISE_FULL_TESTS OR NOT HOUSE_CLANG OR compiler STREQUAL HOUSE_CLANG)
        add_test(NAME house.no_warnings_of_${name} COMMAND ${compiler} -std=c++20 -fsyntax-only -I${EDGEWISE_INCLUDE}
            -isystem ${eigen} -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow -Wno-unknown-attributes -Wno-psabi -Werror ${unit})
        set_tests_properties(house.no_warnings_of_${name} PROPERTIES TIMEOUT 300)
        edgewise_inputs(house.no_warnings_of_${name} ${library})
    endif()
    # Misuse of the library must give exactly one error, with the library's message. clang++ says nothing of parts of -ffast-math.
    foreach(flags mixed_precisions fast_math,-ffast-math fast_math,-funsafe-math-optimizations fast_math,-mfpmath=387 contraction,-mfma,-Werror)
        string(REGEX MATCH "^[a-z_]+" misuse ${flags})
        string(REGEX REPLACE "[^a-z0-9_]+" "_" test ${flags})
        if(test MATCHES "unsafe|387" AND NOT compiler STREQUAL CMAKE_CXX_COMPILER)
            continue()
        endif()
        string(REGEX REPLACE "^[a-z_]+,?|," ";" flags ${flags})
        set(test house.${test}_is_one_error_of_${name})
        add_test(NAME ${test} COMMAND ${CMAKE_COMMAND}
            -D "COMMAND=${compiler};-std=c++20;-fsyntax-only${flags};-I${EDGEWISE_INCLUDE};-isystem;${eigen}"
            -D UNIT=${CMAKE_CURRENT_SOURCE_DIR}/misuse/${misuse}.cpp -P ${CMAKE_CURRENT_SOURCE_DIR}/one_error.cmake)
        edgewise_inputs(${test} ${library})
    endforeach()
endforeach()
