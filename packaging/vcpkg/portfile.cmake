# SPDX-License-Identifier: MIT
# An overlay port of this tree: vcpkg install edgewise --overlay-ports=packaging/vcpkg --no-binarycaching (the cache
# depends only on this folder, not on the tree).
get_filename_component(SOURCE_PATH ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS -D EDGEWISE_TOOL=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/edgewise)
if(EXISTS ${CURRENT_INSTALLED_DIR}/lib/pkgconfig/qhullstatic_r.pc)  # a static Qhull has another name
    file(GLOB_RECURSE descriptions ${CURRENT_PACKAGES_DIR}/edgewise.pc)
    foreach(description IN LISTS descriptions)
        file(READ ${description} text)
        string(REPLACE " -lqhull_r" "" text "${text}")
        string(REPLACE "eigen3 >= 3.4" "eigen3 >= 3.4, qhullstatic_r" text "${text}")
        file(WRITE ${description} "${text}")
    endforeach()
endif()
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE)
