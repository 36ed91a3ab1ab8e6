# SPDX-License-Identifier: MIT
# The manifests have one line per layout (layouts/CMakeLists.txt), probe (probes/CMakeLists.txt) and study
# (src/edgewise/studies/CMakeLists.txt). CMake generates a unit for each table type (some compile as one), so
# that builds are parallel and no other file names a layout.

# edgewise_layout(NAME PRECISION... [VARIANT_OF OTHER] [NUMBER N] [SUPPORT_ONLY] [IN_PROGRAM PRECISION...]): NAME is the
# file's stem, the type and the command-line name; with a number, type and name end with it. A variant hardly differs from
# OTHER: plans leave it out, except `full`. SUPPORT_ONLY: a table for GJK alone. IN_PROGRAM: plan `quick` or a question about
# boxes asks for it, so the program has it even without EDGEWISE_EVERY_LAYOUT.
function(edgewise_layout LAYOUT)
    cmake_parse_arguments(given "SUPPORT_ONLY" "VARIANT_OF;NUMBER" "IN_PROGRAM" ${ARGN})
    set(LAYOUT_FILE ${LAYOUT}.hpp)
    string(APPEND LAYOUT "${given_NUMBER}")
    set_property(GLOBAL PROPERTY EDGEWISE_FILE_OF_${LAYOUT} ${LAYOUT_FILE})
    set(VARIANT_OF ${given_VARIANT_OF})
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_ALL_LAYOUTS ${LAYOUT})
    if(VARIANT_OF)
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_VARIANT_LAYOUTS ${LAYOUT})
    endif()
    set(HAS_FEATURES true)
    if(given_SUPPORT_ONLY)
        set(HAS_FEATURES false)
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_SUPPORT_LAYOUTS ${LAYOUT})
    endif()
    foreach(PRECISION IN LISTS given_UNPARSED_ARGUMENTS)
        set(type ${LAYOUT}_${PRECISION})
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_ALL_LAYOUTS ${type})
        if(EDGEWISE_LAYOUTS AND NOT LAYOUT IN_LIST EDGEWISE_LAYOUTS AND NOT type IN_LIST EDGEWISE_LAYOUTS)
            continue()
        endif()
        configure_file(${PROJECT_SOURCE_DIR}/cmake/table_type.cpp.in ${PROJECT_BINARY_DIR}/registry/${type}.cpp @ONLY)
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_TABLE_TYPES ${type})
        if(PRECISION IN_LIST given_IN_PROGRAM OR EDGEWISE_EVERY_LAYOUT OR EDGEWISE_LAYOUTS)
            set_property(GLOBAL APPEND PROPERTY EDGEWISE_MEASURED_TYPES ${type})
        endif()
    endforeach()
endfunction()

# edgewise_default_builds(ALGORITHM CLASS TYPE...): the algorithm's query loops on these table types are also compiled as
# applications compile them, each as a module (axis build=default). Of a layout that this build leaves out there is none.
function(edgewise_default_builds ALGORITHM CLASS)
    get_property(built GLOBAL PROPERTY EDGEWISE_MEASURED_TYPES)
    foreach(type IN LISTS ARGN)
        if(type IN_LIST built)
            string(REGEX REPLACE "_[^_]*$" "" LAYOUT ${type})
            string(REGEX REPLACE "^.*_" "" PRECISION ${type})
            configure_file(${PROJECT_SOURCE_DIR}/cmake/default_build.cpp.in
                ${PROJECT_BINARY_DIR}/registry/default_${ALGORITHM}_${type}.cpp @ONLY)
            set_property(GLOBAL APPEND PROPERTY EDGEWISE_DEFAULT_BUILDS ${ALGORITHM}_${type})
        endif()
    endforeach()
endfunction()

# edgewise_table_type_list(FILE TYPE...): writes the unit that lists these table types, in this order. PEERS_FOLDER,
# if it is set: the folder with its peers' modules, next to the program.
function(edgewise_table_type_list FILE)
    if(NOT PEERS_FOLDER)
        set(PEERS_FOLDER peers)
    endif()
    foreach(type IN LISTS ARGN)
        string(APPEND TABLE_TYPE_DECLARATIONS "TableType table_type_${type}();\n")
        string(APPEND TABLE_TYPE_ENTRIES "table_type_${type}(), ")
    endforeach()
    get_property(all GLOBAL PROPERTY EDGEWISE_ALL_LAYOUTS)
    list(JOIN all "\", \"" MANIFEST_LAYOUTS)
    set(MANIFEST_LAYOUTS "\"${MANIFEST_LAYOUTS}\"")
    configure_file(${PROJECT_SOURCE_DIR}/cmake/table_type_list.cpp.in ${FILE} @ONLY)
endfunction()

# edgewise_probe(NAME): NAME is the stem of NAME.hpp, and of NAME.cpp if there is one, and the type.
function(edgewise_probe PROBE)
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_PROBES ${PROBE})
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${PROBE}.cpp)
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_PROBE_UNITS ${CMAKE_CURRENT_SOURCE_DIR}/${PROBE}.cpp)
    endif()
endfunction()

# edgewise_study(NAME): the folder NAME of the room studies has a source that defines NAME_study().
function(edgewise_study STUDY)
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_STUDIES ${STUDY})
endfunction()

# edgewise_study_list(FILE STUDY...): writes the unit that lists these studies, in this order.
function(edgewise_study_list FILE)
    foreach(study IN LISTS ARGN)
        string(APPEND STUDY_DECLARATIONS "sweep::Study ${study}_study();\n")
        string(APPEND STUDY_CALLS "studies::${study}_study(), ")
    endforeach()
    configure_file(${PROJECT_SOURCE_DIR}/cmake/study_list.cpp.in ${FILE} @ONLY)
endfunction()

# edgewise_probe_list(FILE PROBE...): writes the unit that lists these probes, in this order.
function(edgewise_probe_list FILE)
    foreach(probe IN LISTS ARGN)
        string(APPEND PROBE_INCLUDES "#include \"edgewise/probes/${probe}.hpp\"\n")
        string(APPEND PROBE_ENTRIES "        probe_of<probes::${probe}>(\"${probe}\"),\n")
    endforeach()
    configure_file(${PROJECT_SOURCE_DIR}/cmake/probe_list.cpp.in ${FILE} @ONLY)
endfunction()

# edgewise_addition(NAME): the folder reports/NAME adds the parts that NAME_addition() lists to the report and the program.
function(edgewise_addition NAME)
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_ADDITIONS ${NAME})
endfunction()

# Call it after the manifests: refuses unknown layouts in EDGEWISE_LAYOUTS, and writes the lists of all probes and studies.
function(edgewise_write_registry)
    get_property(all GLOBAL PROPERTY EDGEWISE_ALL_LAYOUTS)
    foreach(layout IN LISTS EDGEWISE_LAYOUTS)
        if(NOT layout IN_LIST all)
            message(FATAL_ERROR "edgewise: EDGEWISE_LAYOUTS names '${layout}', which layouts/CMakeLists.txt does not; it has: ${all}")
        endif()
    endforeach()
    get_property(probes GLOBAL PROPERTY EDGEWISE_PROBES)
    edgewise_probe_list(${PROJECT_BINARY_DIR}/registry/probe_list.cpp ${probes})
    get_property(studies GLOBAL PROPERTY EDGEWISE_STUDIES)
    edgewise_study_list(${PROJECT_BINARY_DIR}/registry/study_list.cpp ${studies})
endfunction()
