# SPDX-License-Identifier: MIT
# The folders of the rooms. `#include "edgewise/<room>/<file>"` resolves from src/ as it does from the installed package;
# layouts, probes and reports are at the top of the tree and are joined to src/edgewise by links that are kept in it.
set(EDGEWISE_INCLUDE ${CMAKE_CURRENT_SOURCE_DIR}/src)

# edgewise_sources(RESULT FOLDER...): every source below these folders, except replacements of a missing
# dependency (*_unavailable.cpp). A new file needs no line in any list.
function(edgewise_sources RESULT)
    set(all)
    foreach(folder IN LISTS ARGN)
        file(GLOB_RECURSE found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
        list(APPEND all ${found})
    endforeach()
    list(FILTER all EXCLUDE REGEX "_unavailable[.]cpp$")
    list(SORT all)
    set(${RESULT} ${all} PARENT_SCOPE)
endfunction()

# edgewise_stand_in(SOURCES FILE...): in the list named SOURCES, FILE_unavailable.cpp instead of FILE.cpp.
macro(edgewise_stand_in SOURCES)
    foreach(file ${ARGN})
        list(REMOVE_ITEM ${SOURCES} ${PROJECT_SOURCE_DIR}/src/edgewise/${file}.cpp)
        list(APPEND ${SOURCES} ${PROJECT_SOURCE_DIR}/src/edgewise/${file}_unavailable.cpp)
    endforeach()
endmacro()
