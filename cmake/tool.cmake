# SPDX-License-Identifier: MIT
# The tool: everything that measures, as one library for the program and the tests, then the program.
edgewise_write_registry()
get_property(registry_units GLOBAL PROPERTY EDGEWISE_REGISTRY_UNITS)
set_source_files_properties(${registry_units} PROPERTIES COMPILE_OPTIONS "${EDGEWISE_QUERY_LOOP_OPTIONS}")

set(build_info ${PROJECT_BINARY_DIR}/registry/build_info.cpp)
string(TOUPPER ${CMAKE_BUILD_TYPE} type)
add_custom_target(edgewise_build_info BYPRODUCTS ${build_info}
    COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TEMPLATE=${PROJECT_SOURCE_DIR}/cmake/build_info.cpp.in
            -D OUTPUT=${build_info} -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
            -D "FLAGS=${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} -march=${EDGEWISE_TUNE} -ffp-contract=off -fno-tree-slp-vectorize outside query loops"
            -D BUILD_TYPE=${CMAKE_BUILD_TYPE} -D CHARTS=${EDGEWISE_CHARTS_DIR}
            -P ${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake)

include(jemalloc)
include(libpfm)

set(mesh_sources src/geometry/mesh_file_unavailable.cpp)
if(assimp_FOUND)
    set(mesh_sources src/geometry/mesh_file.cpp src/geometry/mesh_parts.cpp src/geometry/mesh_volume.cpp)
endif()

set(callgrind_source src/measure/callgrind_region_unavailable.cpp)
find_path(CALLGRIND_INCLUDE_DIR valgrind/callgrind.h)
if(CALLGRIND_INCLUDE_DIR)
    set(callgrind_source src/measure/callgrind_region.cpp)
endif()

add_library(edgewise_tool STATIC
    ${registry_units}
    ${build_info}
    ${mesh_sources}
    ${EDGEWISE_JEMALLOC_SOURCES}
    ${EDGEWISE_LIBPFM_SOURCES}
    src/algorithms/moore_wilhelms.cpp
    src/cli/progress.cpp
    ${PROJECT_BINARY_DIR}/registry/cache_machines.cpp
    src/measure/cache_level.cpp
    src/measure/cache_machine.cpp
    src/measure/cache_model.cpp
    src/measure/caches.cpp
    src/measure/calibration.cpp
    src/measure/callgrind.cpp
    ${callgrind_source}
    src/measure/child_process.cpp
    src/measure/cold_caches.cpp
    src/measure/count_pass.cpp
    src/measure/counter_arithmetic.cpp
    src/measure/counter_group.cpp
    src/measure/counters.cpp
    src/measure/cpu.cpp
    src/measure/event_choice.cpp
    src/measure/event_table.cpp
    src/measure/fact.cpp
    src/measure/heat_map.cpp
    src/measure/host_machine.cpp
    src/measure/generic_event.cpp
    src/measure/lines_touched.cpp
    src/measure/machine.cpp
    src/measure/machine_choice.cpp
    src/measure/machine_json.cpp
    src/measure/memory_limit.cpp
    src/measure/miss_curve.cpp
    src/measure/page_faults.cpp
    src/measure/perf_error.cpp
    src/measure/perf_event.cpp
    src/measure/processor.cpp
    src/measure/random_chase.cpp
    src/measure/reuse_distance.cpp
    src/measure/scene_caches.cpp
    src/measure/software_watch.cpp
    src/measure/statistics.cpp
    src/measure/touched_bytes.cpp
    src/measure/thread_usage.cpp
    ${PROJECT_BINARY_DIR}/registry/scene_texts.cpp
    src/scene/case_file.cpp
    src/scene/hard/bodies.cpp
    src/scene/hard/contact.cpp
    src/scene/hard/cubes.cpp
    src/scene/hard/families.cpp
    src/scene/hard/maker.cpp
    src/scene/hard/parallel.cpp
    src/scene/hard/sequences.cpp
    src/scene/hard/size.cpp
    src/scene/motion.cpp
    src/scene/scene_cold.cpp
    src/scene/scene_file.cpp
    src/scene/scene_pressure.cpp
    src/scene/scene_proximity.cpp
    src/scene/scene_setup.cpp
    src/scene/scene_static.cpp
    src/scene/scene_texts.cpp
    src/scene/scene_tumble.cpp
    src/scene/scenes.cpp
    src/scene/shapes.cpp
    src/scene/sphere_points.cpp
    src/scene/uv_sphere.cpp
    src/sweep/allocators.cpp
    src/sweep/arena.cpp
    src/sweep/axes.cpp
    src/sweep/broad_phase_trace.cpp
    src/sweep/cell.cpp
    src/sweep/certificates.cpp
    src/sweep/contender.cpp
    src/sweep/crosscheck.cpp
    src/sweep/decompositions.cpp
    src/sweep/draw_heat.cpp
    src/sweep/draw_layout.cpp
    src/sweep/group.cpp
    src/sweep/heap_of_cell.cpp
    src/sweep/measure_steps.cpp
    src/sweep/model_speed.cpp
    src/sweep/paging.cpp
    src/sweep/paging_rows.cpp
    src/sweep/paper_plan.cpp
    src/sweep/plan.cpp
    src/sweep/registry.cpp
    src/sweep/run.cpp
    src/sweep/shapes_of.cpp
    src/sweep/single_cell.cpp
    src/sweep/sqlite.cpp
    src/sweep/stability.cpp
    src/sweep/stability_cases.cpp
    src/sweep/stability_subject.cpp
    src/sweep/stability_tally.cpp
    src/sweep/store.cpp
    src/sweep/table_bytes.cpp
    src/sweep/table_mapping.cpp
    src/sweep/table_memory_cost.cpp
    src/sweep/touched_tables.cpp
    src/sweep/trace_names.cpp
    src/sweep/trace_scene.cpp
    src/sweep/verify.cpp
    src/sweep/watch_algorithm.cpp
    src/sweep/work.cpp
    src/truth/accuracy_band.cpp
    src/truth/brute_force.cpp
    src/truth/certificate.cpp
    src/truth/common_interior.cpp
    src/truth/depth_proof.cpp
    src/truth/dyadic.cpp
    src/truth/exact_body.cpp
    src/truth/exact_depth.cpp
    src/truth/exact_distance.cpp
    src/truth/expanding_polytope.cpp
    src/truth/optimality.cpp
    src/truth/pair_error.cpp
    src/truth/seed_simplex.cpp
    src/truth/support_filter.cpp)
add_dependencies(edgewise_tool edgewise_build_info)
target_link_libraries(edgewise_tool
    PUBLIC edgewise_library nlohmann_json::nlohmann_json fmt::fmt ${GMPXX_LIBRARY} ${GMP_LIBRARY}
    PRIVATE SQLite::SQLite3 ${EDGEWISE_LIBPFM_LIBRARY} edgewise_tuned_flags)
if(assimp_FOUND)
    target_link_libraries(edgewise_tool PRIVATE assimp::assimp)
endif()

add_executable(edgewise_program
    src/cli/cell_options.cpp
    src/cli/command_bench.cpp
    src/cli/command_bytes.cpp
    src/cli/command_calibrate.cpp
    src/cli/command_claims.cpp
    src/cli/command_crosscheck.cpp
    src/cli/command_draw.cpp
    src/cli/command_heat.cpp
    src/cli/command_list.cpp
    src/cli/command_machine.cpp
    src/cli/command_paging.cpp
    src/cli/command_pass.cpp
    src/cli/command_query.cpp
    src/cli/command_report.cpp
    src/cli/command_stability.cpp
    src/cli/command_sweep.cpp
    src/cli/main.cpp
    src/cli/stability_run.cpp)
set_target_properties(edgewise_program PROPERTIES OUTPUT_NAME edgewise RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_link_libraries(edgewise_program PRIVATE edgewise_tool edgewise_reports CLI11::CLI11 edgewise_tuned_flags)
# A parser's templates: twice as long to compile when optimised, and nothing there takes time.
target_compile_options(edgewise_program PRIVATE $<IF:$<BOOL:${EDGEWISE_SANITIZE}>,-O0,-O1>)
