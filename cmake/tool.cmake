# SPDX-License-Identifier: MIT
# The tool: everything that measures, as libraries for the program and the tests, then the program. Only table types
# are compiled for this machine (EDGEWISE_TUNE): nothing else is timed.
edgewise_write_registry()

set(build_info ${PROJECT_BINARY_DIR}/registry/build_info.cpp)
string(TOUPPER ${CMAKE_BUILD_TYPE} type)
add_custom_target(edgewise_build_info BYPRODUCTS ${build_info}
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TEMPLATE=${PROJECT_SOURCE_DIR}/cmake/build_info.cpp.in
            -D OUTPUT=${build_info} -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
            -D "FLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} -march=${EDGEWISE_TUNE} in query loops -ffp-contract=off -fno-tree-slp-vectorize outside them"
            -D BUILD_TYPE=${CMAKE_BUILD_TYPE} -D CHARTS=${EDGEWISE_CHARTS_DIR}
            -P ${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake)

include(jemalloc)
include(libpfm)
find_path(CALLGRIND_INCLUDE_DIR valgrind/callgrind.h)

edgewise_sources(sources src/edgewise/truth src/edgewise/scene src/edgewise/measure src/edgewise/store
    src/edgewise/bench src/edgewise/sweep src/edgewise/studies)
if(NOT assimp_FOUND)
    edgewise_stand_in(sources scene/mesh/mesh_file)
    list(FILTER sources EXCLUDE REGEX "scene/mesh/mesh_(parts|volume)[.]cpp$")
endif()
if(NOT CALLGRIND_INCLUDE_DIR)
    edgewise_stand_in(sources measure/process/callgrind_region)
endif()
if(NOT EDGEWISE_JEMALLOC_OBJECT)
    edgewise_stand_in(sources bench/memory/jemalloc)
endif()
if(NOT EDGEWISE_LIBPFM_LIBRARY)
    edgewise_stand_in(sources measure/counters/libpfm)
endif()

add_library(edgewise_core STATIC
    ${sources} ${EDGEWISE_JEMALLOC_OBJECT} ${build_info} ${PROJECT_BINARY_DIR}/registry/cache_machines.cpp
    ${PROJECT_BINARY_DIR}/registry/scene_texts.cpp)
add_dependencies(edgewise_core edgewise_build_info)
target_link_libraries(edgewise_core
    PUBLIC edgewise_library nlohmann_json::nlohmann_json fmt::fmt ${GMPXX_LIBRARY} ${GMP_LIBRARY}
    PRIVATE SQLite::SQLite3 ${EDGEWISE_LIBPFM_LIBRARY} edgewise_flags)
if(assimp_FOUND)
    target_link_libraries(edgewise_core PRIVATE assimp::assimp)
endif()
edgewise_precompile(edgewise_core <Eigen/Core> <fmt/format.h> <nlohmann/json.hpp> <algorithm> <functional> <map> <memory>
    <optional> <span> <string> <vector>)

# edgewise_tool_for(NAME TUNE): the library with the units of the registry compiled for that machine ("" for any).
function(edgewise_tool_for NAME TUNE)
    get_property(units GLOBAL PROPERTY EDGEWISE_REGISTRY_UNITS)
    set(types ${NAME}_table_types)
    add_library(${types} STATIC ${units})
    target_link_libraries(${types} PRIVATE edgewise_core edgewise_flags)
    target_compile_options(${types} PRIVATE ${EDGEWISE_QUERY_LOOP_OPTIONS} $<$<BOOL:${TUNE}>:-march=${TUNE}>)
    edgewise_precompile(${types} <Eigen/Core> <algorithm> <functional> <map> <memory> <optional> <span> <string> <vector>)
    add_library(${NAME} INTERFACE)
    # The registry and what drives it need each other.
    target_link_libraries(${NAME} INTERFACE $<LINK_GROUP:RESCAN,edgewise_core,${types}>)
endfunction()
edgewise_tool_for(edgewise_tool "${EDGEWISE_TUNE}")

edgewise_sources(cli_sources src/edgewise/cli)
add_library(edgewise_cli OBJECT ${cli_sources})
target_link_libraries(edgewise_cli PUBLIC edgewise_core edgewise_reports CLI11::CLI11 PRIVATE edgewise_flags)
# A parser's templates: twice as long to compile when optimised, and nothing there takes time.
target_compile_options(edgewise_cli PRIVATE $<IF:$<BOOL:${EDGEWISE_SANITIZE}>,-O0,-O1>)
edgewise_precompile(edgewise_cli <CLI/CLI.hpp> <Eigen/Core> <fmt/format.h> <nlohmann/json.hpp>)

add_executable(edgewise_program)
set_target_properties(edgewise_program PROPERTIES OUTPUT_NAME edgewise RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_link_libraries(edgewise_program PRIVATE edgewise_cli edgewise_tool)
