# SPDX-License-Identifier: MIT
# edgewise::measure, the part of measuring without collision detection: traces of a user's own structure, the cache model
# and its machines, reuse distances, bytes by member, and the lock. Debian names: libfmt-dev nlohmann-json3-dev.
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)

# edgewise_machine(NAME): embeds NAME.json from the manifest's folder as text in the library, wherever it is installed.
function(edgewise_machine NAME)
    set(file ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}.json)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    set_property(GLOBAL APPEND_STRING PROPERTY EDGEWISE_MACHINES "    {\"${NAME}\", R\"json(${text})json\"},\n")
endfunction()

function(edgewise_write_machines)
    get_property(MACHINES GLOBAL PROPERTY EDGEWISE_MACHINES)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/cache_machines.cpp.in ${PROJECT_BINARY_DIR}/registry/cache_machines.cpp @ONLY)
endfunction()

add_subdirectory(src/edgewise/measure/cache/machines)

edgewise_sources(sources src/edgewise/input src/edgewise/measure/cache src/edgewise/measure/lock src/edgewise/measure/record
    src/edgewise/measure/touch src/edgewise/measure/traces)
list(APPEND sources ${PROJECT_SOURCE_DIR}/src/edgewise/measure/machine/machine.cpp)  # what `host` is modelled from
add_library(edgewise_measure STATIC ${sources} ${PROJECT_BINARY_DIR}/registry/cache_machines.cpp)
add_library(edgewise::measure ALIAS edgewise_measure)
set_target_properties(edgewise_measure PROPERTIES EXPORT_NAME measure POSITION_INDEPENDENT_CODE ON)
target_compile_features(edgewise_measure PUBLIC cxx_std_20)
target_compile_options(edgewise_measure PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
target_include_directories(edgewise_measure PUBLIC $<BUILD_INTERFACE:${EDGEWISE_INCLUDE}> $<INSTALL_INTERFACE:include>)
target_link_libraries(edgewise_measure
    PRIVATE fmt::fmt $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> $<BUILD_INTERFACE:edgewise_flags>)
# Sources that mutants (tests/mutation) replace stay separate.
edgewise_unite(edgewise_measure src/edgewise/measure/cache/cache_model.cpp src/edgewise/measure/cache/scene_caches.cpp
    src/edgewise/measure/record/comparison.cpp src/edgewise/measure/touch/touch_trace.cpp src/edgewise/measure/traces/trace_file.cpp)
edgewise_precompile(edgewise_measure <fmt/format.h> <nlohmann/json.hpp> <algorithm> <functional> <map> <optional> <span>
    <string> <vector>)
