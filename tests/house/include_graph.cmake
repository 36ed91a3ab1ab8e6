# SPDX-License-Identifier: MIT
# Which headers a header includes, itself or through others, as the project's texts say.

# edgewise_header_name(FILE RESULT): as it is included, without edgewise/.
function(edgewise_header_name FILE RESULT)
    string(REGEX REPLACE "^src/edgewise/" "" name ${FILE})
    set(${RESULT} ${name} PARENT_SCOPE)
endfunction()

# edgewise_include_lines(SOURCE HEADERS RESULT): each include line of these files below SOURCE, as FILE:LINE.
function(edgewise_include_lines SOURCE HEADERS RESULT)
    set(all)
    foreach(header IN LISTS HEADERS)
        file(STRINGS ${SOURCE}/${header} lines REGEX "^#include ")
        list(TRANSFORM lines PREPEND "${header}:")
        list(APPEND all ${lines})
    endforeach()
    set(${RESULT} "${all}" PARENT_SCOPE)
endfunction()

# edgewise_read_includes(TREE LINES): reads the include lines of a revision, which TREE names from now on.
function(edgewise_read_includes TREE LINES)
    foreach(line IN LISTS LINES)
        string(REGEX MATCH "^(.*):#include .(edgewise/)?([^>\"]*)" matched "${line}")
        set(included ${CMAKE_MATCH_3})
        edgewise_header_name(${CMAKE_MATCH_1} name)
        set_property(GLOBAL APPEND PROPERTY ${TREE}_includes_${name} ${included})
    endforeach()
endfunction()

# edgewise_included(TREE NAME RESULT): all headers that NAME includes there, itself or through others.
function(edgewise_included TREE NAME RESULT)
    set(memory ${TREE}_included_${NAME})
    get_property(is_known GLOBAL PROPERTY ${memory} SET)
    if(NOT is_known)
        set_property(GLOBAL PROPERTY ${memory} "")
        get_property(names GLOBAL PROPERTY ${TREE}_includes_${NAME})
        set(all ${names})
        foreach(name IN LISTS names)
            edgewise_included(${TREE} ${name} more)
            list(APPEND all ${more})
        endforeach()
        list(REMOVE_DUPLICATES all)
        set_property(GLOBAL PROPERTY ${memory} "${all}")
    endif()
    get_property(all GLOBAL PROPERTY ${memory})
    set(${RESULT} "${all}" PARENT_SCOPE)
endfunction()
