# SPDX-License-Identifier: MIT
# recipes.cmake with SOURCE and VERSION: the recipes for other package managers, as far as their tools are not needed: the
# vcpkg port runs with its helpers replaced by what notes that they were called, its manifest is JSON, Conan's recipe is
# Python, and all name this version. Scripts pass shellcheck where that is installed.
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
find_program(PYTHON python3)
if(PYTHON)
    execute_process(COMMAND ${PYTHON} -c "import ast, sys; ast.parse(open(sys.argv[1]).read())" ${packaging}/conan/conanfile.py
                    RESULT_VARIABLE result ERROR_VARIABLE error)
    if(NOT result EQUAL 0)
        message(SEND_ERROR "conanfile.py is no Python:\n${error}")
    endif()
else()
    message("no python3 here: conanfile.py is not parsed")
endif()
find_program(SHELLCHECK shellcheck)
if(SHELLCHECK)
    execute_process(COMMAND ${SHELLCHECK} ${packaging}/try_packages ${packaging}/make_packages
                    RESULT_VARIABLE result OUTPUT_VARIABLE error)
    if(NOT result EQUAL 0)
        message(SEND_ERROR "shellcheck:\n${error}")
    endif()
else()
    message("no shellcheck here: the scripts in packaging are not looked at by it")
endif()
