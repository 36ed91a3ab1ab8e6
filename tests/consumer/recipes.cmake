# SPDX-License-Identifier: MIT
# recipes.cmake with SOURCE and VERSION: checks the recipes for other package managers without their tools. The
# vcpkg port runs with helpers that only record their calls; its manifest must be JSON, Conan's recipe must be Python, and
# all must name this version. Scripts pass shellcheck if it is installed.
cmake_minimum_required(VERSION 3.25)
set(packaging ${SOURCE}/packaging)

set(called)
foreach(helper check_linkage cmake_configure cmake_install cmake_config_fixup fixup_pkgconfig install_copyright)
    cmake_language(EVAL CODE "macro(vcpkg_${helper})\nlist(APPEND called ${helper})\nendmacro()")
endforeach()
set(CURRENT_PACKAGES_DIR ${CMAKE_CURRENT_LIST_DIR}/none)
include(${packaging}/vcpkg/portfile.cmake)
list(LENGTH called count)
if(NOT count EQUAL 6 OR NOT EXISTS ${SOURCE_PATH}/CMakeLists.txt)
    message(SEND_ERROR "the vcpkg port calls '${called}' in ${SOURCE_PATH}")
endif()

file(READ ${packaging}/vcpkg/vcpkg.json manifest)
string(JSON version GET "${manifest}" version)
if(NOT version STREQUAL VERSION)
    message(SEND_ERROR "vcpkg.json is of version ${version}, not ${VERSION}")
endif()

file(STRINGS ${packaging}/conan/conanfile.py line REGEX "version = \"${VERSION}\"")
if(NOT line)
    message(SEND_ERROR "conanfile.py is not of version ${VERSION}")
endif()
# check_by(TOOL WHAT ARGUMENT...): the tool must accept the recipes; skipped if it is not installed.
function(check_by TOOL WHAT)
    find_program(${TOOL} ${TOOL})
    if(NOT ${TOOL})
        message("no ${TOOL} here to check ${WHAT}")
        return()
    endif()
    execute_process(COMMAND ${${TOOL}} ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE error ERROR_VARIABLE error)
    if(NOT result EQUAL 0)
        message(SEND_ERROR "${TOOL} refuses ${WHAT}:\n${error}")
    endif()
endfunction()
check_by(python3 conanfile.py -c "import ast, sys; ast.parse(open(sys.argv[1]).read())" ${packaging}/conan/conanfile.py)
check_by(shellcheck "the scripts in packaging" ${packaging}/try_packages ${packaging}/make_packages)
