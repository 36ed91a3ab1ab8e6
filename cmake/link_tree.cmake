# SPDX-License-Identifier: MIT
# In the tree a header is src/<room>/<file>; for whoever includes it, it is edgewise/<room>/<file>, as it will be
# once installed. Links in the build folder make both true without copies.
set(EDGEWISE_INCLUDE ${CMAKE_CURRENT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${EDGEWISE_INCLUDE}/edgewise)
foreach(room geometry table algorithms truth scene measure sweep cli)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/src/${room} ${EDGEWISE_INCLUDE}/edgewise/${room} SYMBOLIC)
endforeach()
foreach(room layouts probes reports)
    file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${room} ${EDGEWISE_INCLUDE}/edgewise/${room} SYMBOLIC)
endforeach()
