# SPDX-License-Identifier: MIT
# Which header of the project includes which, as its text says.

# edgewise_header_name(FILE RESULT): as it is included, without edgewise/.
function(edgewise_header_name FILE RESULT)
    string(REGEX REPLACE "^src/edgewise/" "" name ${FILE})
    set(${RESULT} ${name} PARENT_SCOPE)
endfunction()

# edgewise_include_graph(SOURCE HEADERS): sets header_names, and includes_of_NAME for each of these files below SOURCE.
macro(edgewise_include_graph SOURCE HEADERS)
    set(header_names)
    foreach(header ${HEADERS})
        edgewise_header_name(${header} name)
        file(STRINGS ${SOURCE}/${header} lines REGEX "^#include [<\"](Eigen|edgewise)/")
        list(TRANSFORM lines REPLACE "^#include .(edgewise/)?([^>\"]*).*" "\\2")
        set(includes_of_${name} "${lines}")
        list(APPEND header_names ${name})
    endforeach()
endmacro()

# edgewise_includers(NAMES RESULT): NAMES and every header that includes one of them, itself or through others.
function(edgewise_includers NAMES RESULT)
    set(found ${NAMES})
    set(grows TRUE)
    while(grows)
        set(grows FALSE)
        foreach(name IN LISTS header_names)
            if(name IN_LIST found)
                continue()
            endif()
            foreach(included IN LISTS includes_of_${name})
                if(included IN_LIST found)
                    list(APPEND found ${name})
                    set(grows TRUE)
                    break()
                endif()
            endforeach()
        endforeach()
    endwhile()
    set(${RESULT} ${found} PARENT_SCOPE)
endfunction()
