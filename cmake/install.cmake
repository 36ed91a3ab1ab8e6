# SPDX-License-Identifier: MIT
# Installs find_package(edgewise) with the target edgewise::edgewise, with COMPONENTS measure edgewise::measure, and edgewise.pc
# for users without CMake. The program is compiled for this machine, so only --component tool installs it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME dev)

foreach(room geometry table layout_parts algorithms)
    install(DIRECTORY src/edgewise/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/edgewise FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES src/edgewise/record.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/edgewise)
install(DIRECTORY layouts DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/edgewise FILES_MATCHING PATTERN "*.hpp" PATTERN campaign EXCLUDE)

if(TARGET edgewise_measure)
    foreach(part cache lock record touch traces)
        install(DIRECTORY src/edgewise/measure/${part} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/edgewise/measure
                FILES_MATCHING PATTERN "*.hpp" PATTERN machines EXCLUDE)
    endforeach()
    install(FILES src/edgewise/measure/expected.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/edgewise/measure)
endif()

install(FILES LICENSE README.md docs/library.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS edgewise_library EXPORT edgewise_targets)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/edgewise)
install(EXPORT edgewise_targets NAMESPACE edgewise:: DESTINATION ${package_folder})
if(TARGET edgewise_measure)
    install(TARGETS edgewise_measure EXPORT edgewise_measure_targets)
    install(EXPORT edgewise_measure_targets NAMESPACE edgewise:: DESTINATION ${package_folder})
endif()
configure_package_config_file(cmake/edgewise-config.cmake.in edgewise-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(edgewise-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/edgewise-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/edgewise-config-version.cmake
        DESTINATION ${package_folder})

# From lib/<where>/pkgconfig up to the prefix.
file(RELATIVE_PATH EDGEWISE_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(packaging/edgewise.pc.in edgewise.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/edgewise.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
