# SPDX-License-Identifier: MIT
#
# What makes a build from nothing take fewer minutes; what makes the next one take few: compiler_cache.cmake.

# edgewise_precompile(TARGET HEADER...): these headers of other projects, parsed once for all of the target's sources.
function(edgewise_precompile TARGET)
    target_precompile_headers(${TARGET} PRIVATE ${ARGN})
    target_compile_options(${TARGET} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# edgewise_unite(TARGET FILE...): its sources compiled some at a time as one, which parses and instantiates once what
# they share; not these files, whose names for themselves others have too.
# Off where each file is wanted by itself: with EDGEWISE_UNITY=OFF compile_commands.json has every file.
function(edgewise_unite TARGET)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ${EDGEWISE_UNITY} UNITY_BUILD_BATCH_SIZE 10)
    if(ARGN)
        set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
endfunction()
