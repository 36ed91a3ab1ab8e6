# SPDX-License-Identifier: MIT
# The machines that come with Edgewise become text in the program: it finds them wherever it is installed.

# edgewise_machine(NAME): the file NAME.json beside the manifest.
function(edgewise_machine NAME)
    set(file ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}.json)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    set_property(GLOBAL APPEND_STRING PROPERTY EDGEWISE_MACHINES "    {\"${NAME}\", R\"json(${text})json\"},\n")
endfunction()

function(edgewise_write_machines)
    get_property(MACHINES GLOBAL PROPERTY EDGEWISE_MACHINES)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/cache_machines.cpp.in ${PROJECT_BINARY_DIR}/registry/cache_machines.cpp @ONLY)
endfunction()
