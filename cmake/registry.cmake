# SPDX-License-Identifier: MIT
# The manifests: one line a layout (layouts/CMakeLists.txt), one line a probe (probes/CMakeLists.txt). From each line
# come generated units, one a table type, so that builds stay parallel and nothing else names a layout.

# edgewise_layout(NAME PRECISION...): NAME is the file's stem, the type and the command-line name.
function(edgewise_layout LAYOUT)
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_ALL_LAYOUTS ${LAYOUT})
    if(EDGEWISE_LAYOUTS AND NOT LAYOUT IN_LIST EDGEWISE_LAYOUTS)
        return()
    endif()
    foreach(PRECISION IN LISTS ARGN)
        # Under sanitizers a unit takes half a minute to compile, and the text of all precisions is one.
        if(EDGEWISE_SANITIZE AND NOT PRECISION STREQUAL f64 AND NOT LAYOUT MATCHES "^(aos|lean|quantised)$")
            continue()
        endif()
        set(unit ${PROJECT_BINARY_DIR}/registry/${LAYOUT}_${PRECISION}.cpp)
        configure_file(${PROJECT_SOURCE_DIR}/cmake/table_type.cpp.in ${unit} @ONLY)
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_TABLE_TYPES ${LAYOUT}_${PRECISION})
        set_property(GLOBAL APPEND PROPERTY EDGEWISE_REGISTRY_UNITS ${unit})
    endforeach()
endfunction()

# edgewise_probe(NAME): NAME is the file's stem and the type.
function(edgewise_probe PROBE)
    set(unit ${PROJECT_BINARY_DIR}/registry/probe_${PROBE}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/probe.cpp.in ${unit} @ONLY)
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_PROBES ${PROBE})
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_REGISTRY_UNITS ${unit})
endfunction()

# The lists of all entries, in the manifests' order; to be called when both manifests are read.
function(edgewise_write_registry)
    get_property(all GLOBAL PROPERTY EDGEWISE_ALL_LAYOUTS)
    foreach(layout IN LISTS EDGEWISE_LAYOUTS)
        if(NOT layout IN_LIST all)
            message(FATAL_ERROR "edgewise: EDGEWISE_LAYOUTS names '${layout}', which layouts/CMakeLists.txt does not; it has: ${all}")
        endif()
    endforeach()
    get_property(table_types GLOBAL PROPERTY EDGEWISE_TABLE_TYPES)
    get_property(probes GLOBAL PROPERTY EDGEWISE_PROBES)
    foreach(type IN LISTS table_types)
        string(APPEND TABLE_TYPE_DECLARATIONS "TableType table_type_${type}();\n")
        string(APPEND TABLE_TYPE_ENTRIES "table_type_${type}(), ")
    endforeach()
    foreach(probe IN LISTS probes)
        string(APPEND PROBE_DECLARATIONS "std::unique_ptr<Probe> probe_${probe}();\n")
        string(APPEND PROBE_ENTRIES "        all.push_back(probe_${probe}());\n")
    endforeach()
    set(unit ${PROJECT_BINARY_DIR}/registry/registry_lists.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/registry_lists.cpp.in ${unit} @ONLY)
    set_property(GLOBAL APPEND PROPERTY EDGEWISE_REGISTRY_UNITS ${unit})
endfunction()
