# SPDX-License-Identifier: MIT
# The tool: libraries for the program and the tests, then the program. Only table types are compiled for this machine
# (EDGEWISE_TUNE), because only they are timed.
edgewise_write_registry()

set(build_info ${PROJECT_BINARY_DIR}/registry/build_info.cpp)
string(TOUPPER ${CMAKE_BUILD_TYPE} type)
set(COMPILER "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
set(FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} -ffp-contract=off -fno-tree-slp-vectorize")
configure_file(${PROJECT_SOURCE_DIR}/cmake/build_info.cpp.in ${build_info} @ONLY)

# The revision is a source of the program. Tests have the library's own answer, so that a commit alone links none of them
# again and tests/run sees that they are unchanged.
set(revision ${PROJECT_BINARY_DIR}/registry/revision.cpp)
set(no_revision ${PROJECT_BINARY_DIR}/registry/no_revision.cpp)
add_custom_target(edgewise_revision BYPRODUCTS ${revision}
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TEMPLATE=${PROJECT_SOURCE_DIR}/cmake/revision.cpp.in
            -D OUTPUT=${revision} -P ${PROJECT_SOURCE_DIR}/cmake/write_revision.cmake)
set(REVISION "none: not the program, but a test")
configure_file(${PROJECT_SOURCE_DIR}/cmake/revision.cpp.in ${no_revision} @ONLY)
set_source_files_properties(${revision} ${no_revision} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)

set(store_schema ${PROJECT_SOURCE_DIR}/src/edgewise/store/schema.sql)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${store_schema})
file(READ ${store_schema} STORE_SCHEMA)
configure_file(${PROJECT_SOURCE_DIR}/cmake/store_schema.cpp.in ${PROJECT_BINARY_DIR}/registry/store_schema.cpp @ONLY)

# The rows of the table in docs/figures.md are those of store::vocabulary.
set(figures ${PROJECT_SOURCE_DIR}/docs/figures.md)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${figures})
file(READ ${figures} page)
string(FIND "${page}" "| `" first)
string(SUBSTRING "${page}" ${first} -1 rows)
string(REGEX REPLACE "[|] `([^`]+)` [|] ([^|]+) [|] ([a-z]+) [|] ([a-z]+) [|] ([^|]+) [|]\n"
    "    {\"\\1\", \"\\2\", Population::\\3, Repeats::\\4, \"\\5\"},\n" rows "${rows}")
string(REPLACE "Repeats::yes" "Repeats::exactly" rows "${rows}")
string(REPLACE "Repeats::no" "Repeats::timed" rows "${rows}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/registry/edgewise/store/figure_rows.inc CONTENT "${rows}" @ONLY)

# edgewise_text(FILE HEADER NAME): registry/NAME.cpp defines edgewise::NAME, which HEADER declares: the text of the file.
function(edgewise_text FILE HEADER NAME)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${FILE})
    file(READ ${PROJECT_SOURCE_DIR}/${FILE} TEXT)
    string(REGEX REPLACE ".*::" "" unit ${NAME})
    configure_file(${PROJECT_SOURCE_DIR}/cmake/text.cpp.in ${PROJECT_BINARY_DIR}/registry/${unit}.cpp @ONLY)
endfunction()
edgewise_text(src/edgewise/measure/counters/events.json measure/counters/events.hpp measure::event_texts)
edgewise_text(src/edgewise/scene/kinds/kinds.json scene/scenes.hpp scene::kind_texts)
edgewise_text(src/edgewise/scene/kinds/kinds.json reports/reader.hpp reports::scene_kind_texts)
edgewise_text(src/edgewise/cli/usage/examples.json cli/usage/usage.hpp cli::example_texts)
edgewise_text(src/edgewise/studies/phases/phases.json studies/phases/phases.hpp studies::phase_texts)

set(shells bash zsh fish)
foreach(shell IN LISTS shells)
    edgewise_text(src/edgewise/cli/usage/completion.${shell} cli/usage/usage.hpp cli::${shell}_script)
endforeach()
include(jemalloc)
include(libpfm)

edgewise_sources(sources src/edgewise/truth src/edgewise/scene src/edgewise/measure src/edgewise/store
    src/edgewise/bench src/edgewise/sweep src/edgewise/studies)
get_target_property(measured edgewise_measure SOURCES)
list(REMOVE_ITEM sources ${measured})
if(NOT assimp_FOUND)
    edgewise_stand_in(sources scene/mesh/assimp_file)
endif()
if(NOT EDGEWISE_JEMALLOC_OBJECT)
    edgewise_stand_in(sources bench/memory/jemalloc)
endif()
if(NOT EDGEWISE_LIBPFM_LIBRARY)
    edgewise_stand_in(sources measure/counters/libpfm)
endif()

# Code that steers measurements need not be fast, and code of sanitizers takes longest to optimise.
set(steering)
if(EDGEWISE_SANITIZE)
    edgewise_sources(steered src/edgewise/store src/edgewise/sweep src/edgewise/studies)
    list(REMOVE_ITEM sources ${steered})
    add_library(edgewise_steering OBJECT ${steered})
    target_link_libraries(edgewise_steering
        PRIVATE edgewise_library nlohmann_json::nlohmann_json fmt::fmt SQLite::SQLite3 TBB::tbb edgewise_flags)
    target_include_directories(edgewise_steering PRIVATE ${PROJECT_BINARY_DIR}/registry)
    target_compile_options(edgewise_steering PRIVATE -O0)
    edgewise_unite(edgewise_steering src/edgewise/store/sqlite.cpp src/edgewise/store/store.cpp)
    edgewise_precompile(edgewise_steering <Eigen/Core> <fmt/format.h> <nlohmann/json.hpp> <algorithm> <functional> <map>
        <memory> <optional> <span> <string> <vector>)
    set(steering $<TARGET_OBJECTS:edgewise_steering>)
endif()

get_property(probe_units GLOBAL PROPERTY EDGEWISE_PROBE_UNITS)
set(lists ${PROJECT_BINARY_DIR}/registry/probe_list.cpp ${PROJECT_BINARY_DIR}/registry/study_list.cpp)
# The tool's own code is not timed, but scans decide the speed of a campaign: compiled for this machine's widest vectors.
if(EDGEWISE_TUNE)
    set_source_files_properties(src/edgewise/truth/filter/scanned_body.cpp PROPERTIES
        COMPILE_OPTIONS -march=${EDGEWISE_TUNE} SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endif()
add_library(edgewise_core STATIC ${steering} ${PROJECT_BINARY_DIR}/registry/kind_texts.cpp
    ${sources} ${probe_units} ${lists} ${EDGEWISE_JEMALLOC_OBJECT} ${build_info} ${no_revision}
    ${PROJECT_BINARY_DIR}/registry/scene_texts.cpp ${PROJECT_BINARY_DIR}/registry/plan_texts.cpp
    ${PROJECT_BINARY_DIR}/registry/phase_texts.cpp
    ${PROJECT_BINARY_DIR}/registry/store_schema.cpp ${PROJECT_BINARY_DIR}/registry/event_texts.cpp)
target_include_directories(edgewise_core PUBLIC ${PROJECT_BINARY_DIR}/registry)
target_link_libraries(edgewise_core
    PUBLIC edgewise_library edgewise_measure nlohmann_json::nlohmann_json fmt::fmt TBB::tbb ${GMPXX_LIBRARY} ${GMP_LIBRARY}
    PRIVATE SQLite::SQLite3 ZLIB::ZLIB ${EDGEWISE_LIBPFM_LIBRARY} ${CMAKE_DL_LIBS} edgewise_flags)
if(assimp_FOUND)
    target_link_libraries(edgewise_core PRIVATE assimp::assimp)
endif()
foreach(library fcl bullet)
    edgewise_text(src/edgewise/scene/${library}_test.txt scene/case_text.hpp scene::${library}_test_text)
    target_sources(edgewise_core PRIVATE ${PROJECT_BINARY_DIR}/registry/${library}_test_text.cpp)
endforeach()
edgewise_sources(counters src/edgewise/measure/counters)  # libpfm has the kernel's types again
# Sources that mutants (tests/mutation), and tests with probes and studies of their own, replace stay separate; and those that
# ask V-Clip or GJK, so that an edit of an algorithm compiles nothing else here.
edgewise_unite(edgewise_core ${counters} ${lists} src/edgewise/scene/kinds/scene_tumble.cpp src/edgewise/scene/scene_file.cpp
    src/edgewise/measure/process/callgrind.cpp src/edgewise/scene/motion.cpp
    src/edgewise/store/sqlite.cpp src/edgewise/store/store.cpp src/edgewise/studies/effort/effort.cpp src/edgewise/studies/stability/stability_tally.cpp
    src/edgewise/studies/phases/phases.cpp src/edgewise/studies/coherence/coherence_study.cpp src/edgewise/sweep/prepared_cell.cpp
    src/edgewise/bench/trace/walk.cpp probes/work.cpp
    src/edgewise/truth/checked_answer.cpp src/edgewise/truth/filter/float_proof.cpp src/edgewise/truth/filter/posed_pair.cpp
    src/edgewise/studies/fields/best_groups.cpp
    src/edgewise/studies/fields/field_trace.cpp src/edgewise/studies/fields/fields.cpp
    src/edgewise/studies/gate/run.cpp src/edgewise/studies/thrash/factorial.cpp src/edgewise/studies/thrash/memory_demand.cpp
    src/edgewise/studies/threads/scaling.cpp src/edgewise/truth/certificate.cpp src/edgewise/truth/exact_distance.cpp
    src/edgewise/truth/exact_proof.cpp src/edgewise/truth/exact_body.cpp)
if(EDGEWISE_SANITIZE)  # truth is slow and manages no memory by hand: the library's own checks instead of sanitizers
    edgewise_sources(oracle src/edgewise/truth)
    set_source_files_properties(${oracle} PROPERTIES COMPILE_OPTIONS "-O2;-fno-sanitize=all" COMPILE_DEFINITIONS ${EDGEWISE_CHECKED}
        SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endif()
edgewise_precompile(edgewise_core <Eigen/Core> <fmt/format.h> <nlohmann/json.hpp> <algorithm> <functional> <map> <memory>
    <optional> <span> <string> <vector>)

# edgewise_write_list(NAME TUNE TYPE...): registry/NAME_list.cpp, which lists these table types compiled for that machine.
function(edgewise_write_list NAME TUNE)
    string(JOIN " " TABLE_TYPE_FLAGS "; query loops:" ${EDGEWISE_QUERY_LOOP_OPTIONS})
    if(TUNE)
        string(APPEND TABLE_TYPE_FLAGS " -march=${TUNE}")
    endif()
    edgewise_table_type_list(${PROJECT_BINARY_DIR}/registry/${NAME}_list.cpp ${ARGN})
endfunction()

# edgewise_table_types(NAME TUNE TYPE...): the object library NAME_table_types of these table types, compiled for that machine
# ("" for any), and of the list that edgewise_write_list(NAME ...) wrote. TYPES_HEADERS, if it is set: the library, with the
# same flags, that precompiled their headers.
function(edgewise_table_types NAME TUNE)
    list(TRANSFORM ARGN REPLACE "(.+)" "${PROJECT_BINARY_DIR}/registry/\\1.cpp" OUTPUT_VARIABLE units)
    set(types ${NAME}_table_types)
    add_library(${types} OBJECT ${PROJECT_BINARY_DIR}/registry/${NAME}_list.cpp ${units})
    # All precisions of a layout in one unit take a fifth less time than separately: they parse and instantiate the same code.
    set_target_properties(${types} PROPERTIES UNITY_BUILD ${EDGEWISE_UNITY} UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${PROJECT_BINARY_DIR}/registry/${NAME}_list.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    foreach(unit IN LISTS units)
        string(REGEX REPLACE "^.*/(.*)_[^_]*$" "\\1" layout ${unit})
        set_source_files_properties(${unit} PROPERTIES UNITY_GROUP ${layout})
    endforeach()
    target_link_libraries(${types} PRIVATE edgewise_core edgewise_flags edgewise_query_loops)
    target_compile_options(${types} PRIVATE $<$<BOOL:${TUNE}>:-march=${TUNE}>)
    if(TYPES_HEADERS)
        target_compile_options(${types} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> -Winvalid-pch)
        target_precompile_headers(${types} REUSE_FROM ${TYPES_HEADERS})
        return()
    endif()
    edgewise_precompile(${types} <Eigen/Core> <nlohmann/json.hpp> <algorithm> <functional> <map> <memory> <optional> <span> <string> <vector>)
endfunction()

# edgewise_tool_for(NAME TUNE TYPES [PART]): the library of the table types in the list TYPES, compiled for that machine; those
# that the library PART has are taken from there.
function(edgewise_tool_for NAME TUNE TYPES)
    edgewise_write_list(${NAME} "${TUNE}" ${${TYPES}})
    set(compiled ${${TYPES}})
    set(objects)
    foreach(part IN LISTS ARGN)
        get_target_property(types ${part} EDGEWISE_TYPES)
        list(REMOVE_ITEM compiled ${types})
        get_target_property(sources ${part} INTERFACE_SOURCES)
        list(APPEND objects "$<FILTER:${sources},EXCLUDE,${part}_list[.]cpp>")
    endforeach()
    edgewise_table_types(${NAME} "${TUNE}" ${compiled})
    add_library(${NAME} INTERFACE)
    set_target_properties(${NAME} PROPERTIES EDGEWISE_TYPES "${${TYPES}}")
    # Objects, not an archive: the registry and the code that uses it need each other.
    target_sources(${NAME} INTERFACE $<TARGET_OBJECTS:${NAME}_table_types> ${objects})
    target_link_libraries(${NAME} INTERFACE edgewise_core)
endfunction()
get_property(table_types GLOBAL PROPERTY EDGEWISE_MEASURED_TYPES)
get_property(all_types GLOBAL PROPERTY EDGEWISE_TABLE_TYPES)

# The table types of few layouts, for the tests that run after every edit: after an edit of an algorithm these tests do not wait
# for the other table types.
set(few_types ${table_types})
if(NOT EDGEWISE_LAYOUTS)
    list(FILTER few_types INCLUDE REGEX "^(aos|lean|points_soa)_[^_]*$")
endif()
edgewise_tool_for(edgewise_few_tool "${EDGEWISE_TUNE}" few_types)
set(TYPES_HEADERS edgewise_few_tool_table_types)
edgewise_tool_for(edgewise_tool "${EDGEWISE_TUNE}" table_types edgewise_few_tool)
unset(TYPES_HEADERS)
# Tests ask every table type. Those that the program leaves out are compiled in a third of the time, because they are not
# timed: hardly optimised, and six in a unit, of which each takes four seconds for what they have in common.
if(EDGEWISE_TESTS)
    edgewise_tool_for(edgewise_all_tool "${EDGEWISE_TUNE}" all_types edgewise_tool)
    target_compile_options(edgewise_all_tool_table_types PRIVATE -Og -Dflatten=noinline)
    set_target_properties(edgewise_all_tool_table_types PROPERTIES UNITY_BUILD_MODE BATCH UNITY_BUILD_BATCH_SIZE 6)
    set(EDGEWISE_ALL_TABLE_TYPES edgewise_few_tool_table_types edgewise_tool_table_types edgewise_all_tool_table_types)
endif()

edgewise_sources(cli_sources src/edgewise/cli)
list(TRANSFORM shells REPLACE "(.+)" "${PROJECT_BINARY_DIR}/registry/\\1_script.cpp" OUTPUT_VARIABLE scripts)
add_library(edgewise_cli OBJECT ${cli_sources} ${scripts} ${PROJECT_BINARY_DIR}/registry/example_texts.cpp ${revision})
add_dependencies(edgewise_cli edgewise_revision)
target_link_libraries(edgewise_cli PUBLIC edgewise_core edgewise_reports CLI11::CLI11 PRIVATE edgewise_flags)
# Templates of the parser of options need not be fast, and more optimisation takes a third more time to compile. But not -O0: of an
# inline function the linker keeps one copy for the whole program, perhaps that of these objects.
target_compile_options(edgewise_cli PRIVATE -Og)
target_compile_definitions(edgewise_cli PRIVATE ${EDGEWISE_CHECKED})
edgewise_unite(edgewise_cli)
edgewise_precompile(edgewise_cli <CLI/CLI.hpp> <Eigen/Core> <fmt/format.h> <nlohmann/json.hpp>)

add_executable(edgewise_program)
set_target_properties(edgewise_program PROPERTIES OUTPUT_NAME edgewise RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_link_libraries(edgewise_program PRIVATE edgewise_cli edgewise_tool)
# Query loops as applications compile them: modules, because code of two kinds of flags must not share one symbol.
get_property(default_builds GLOBAL PROPERTY EDGEWISE_DEFAULT_BUILDS)
foreach(name IN LISTS default_builds)
    add_library(default_${name} MODULE EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/registry/default_${name}.cpp)
    target_link_libraries(default_${name} PRIVATE edgewise_library)
    target_compile_options(default_${name} PRIVATE -O2 -fvisibility=hidden $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
    target_compile_definitions(default_${name} PRIVATE EDGEWISE_PEER_FLAGS="-O2" EDGEWISE_PEER_LIBRARY="Edgewise")
    set_target_properties(default_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name}
        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/default_builds)
    if(NOT EDGEWISE_SANITIZE)
        add_dependencies(edgewise_program default_${name})
    endif()
endforeach()

# Tests under sanitizers do not start it.
if(EDGEWISE_SANITIZE)
    set_target_properties(edgewise_program edgewise_cli edgewise_reports edgewise_report_tables PROPERTIES EXCLUDE_FROM_ALL ON)
endif()

# The program with a few table types for any processor since 2013: Valgrind can run it. It is also a second build of
# the query loops, which must give the same answers. It is built if tests need it (tests/run full).
set(EDGEWISE_SIM FALSE)
if(NOT EDGEWISE_SANITIZE AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(EDGEWISE_SIM TRUE)
    set(sim_types)
    foreach(type IN LISTS all_types)
        if(type IN_LIST EDGEWISE_SIM_LAYOUTS)
            list(APPEND sim_types ${type})
        endif()
    endforeach()
    set(EDGEWISE_SIM_TUNE x86-64-v3)
    set(PEERS_FOLDER sim_peers)
    edgewise_tool_for(edgewise_sim_tool ${EDGEWISE_SIM_TUNE} sim_types)
    unset(PEERS_FOLDER)
    # Line tables for `edgewise bench effort --by-phase`; they do not change the instructions.
    target_compile_options(edgewise_sim_tool_table_types PRIVATE -g1)
    add_executable(edgewise_sim EXCLUDE_FROM_ALL)
    set_target_properties(edgewise_sim PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
    target_link_libraries(edgewise_sim PRIVATE edgewise_cli edgewise_sim_tool)
    set_target_properties(edgewise_sim_tool_table_types PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
