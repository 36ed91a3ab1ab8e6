# SPDX-License-Identifier: MIT
# cpack makes two Debian packages: edgewise, the program, and libedgewise-dev, the library with its headers. The
# program is compiled for EDGEWISE_TUNE, which must be empty in a package for others (packaging/make_packages empties it).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME edgewise)
set(CPACK_PACKAGE_CONTACT "The Edgewise developers <edgewise@localhost.localdomain>")
set(CPACK_PACKAGE_FILE_NAME edgewise-${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL dev tool)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libedgewise-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libqhull-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libtbb-dev, libfmt-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "V-Clip and Enhanced GJK as C++20 headers over data layouts that can be
 exchanged, and the static library of what they share. Queries in several
 threads want libtbb-dev, edgewise::measure wants libfmt-dev.")

set(CPACK_DEBIAN_TOOL_PACKAGE_NAME edgewise)
set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "nodejs")
set(CPACK_COMPONENT_TOOL_DESCRIPTION "Measures what V-Clip and Enhanced GJK cost in memory, cache and time over
 interchangeable data layouts, with every answer checked against exact
 arithmetic, and writes a report.")

# Files that Debian requires in every package.
set(debian ${PROJECT_SOURCE_DIR}/packaging/debian)
set(made ${PROJECT_BINARY_DIR}/packaging)
file(MAKE_DIRECTORY ${made})
file(WRITE ${made}/changelog "edgewise (${PROJECT_VERSION}) unstable; urgency=medium

  * What has changed stands in CHANGELOG.md of the source.

 -- The Edgewise developers <edgewise@localhost.localdomain>  Tue, 24 Nov 2026 12:00:00 +0000
")
execute_process(COMMAND gzip -9nc ${made}/changelog OUTPUT_FILE ${made}/changelog.gz)
foreach(package_of dev:libedgewise-dev tool:edgewise)
    string(REPLACE ":" ";" pair ${package_of})
    list(GET pair 0 component)
    list(GET pair 1 package)
    install(FILES ${debian}/copyright DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES ${made}/changelog.gz DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
if(TARGET edgewise_program)
    install(TARGETS edgewise_program RUNTIME DESTINATION bin COMPONENT tool EXCLUDE_FROM_ALL)
    # The program prints its manual page and what shells complete from its own commands.
    foreach(text man:man/man1/edgewise.1 bash:bash-completion/completions/edgewise zsh:zsh/site-functions/_edgewise
            fish:fish/vendor_completions.d/edgewise.fish)
        string(REPLACE ":" ";" pair ${text})
        list(GET pair 0 name)
        list(GET pair 1 file)
        set(command edgewise_program --print ${name})
        if(name STREQUAL man)
            list(APPEND command | gzip -9nc)
            string(APPEND file .gz)
        endif()
        get_filename_component(folder ${file} DIRECTORY)
        file(MAKE_DIRECTORY ${made}/${folder})
        add_custom_command(TARGET edgewise_program POST_BUILD COMMAND ${command} > ${made}/${file})
        install(FILES ${made}/${file} DESTINATION share/${folder} COMPONENT tool EXCLUDE_FROM_ALL)
    endforeach()
endif()
include(CPack)
