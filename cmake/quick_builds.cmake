# SPDX-License-Identifier: MIT
# A compiler cache, where one is installed and the top project is ours: a clone beside another then compiles in minutes.
# Precompiled headers need what is said here of times and macros; paths count from the tree's root.
find_program(EDGEWISE_CCACHE ccache)
if(EDGEWISE_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_CURRENT_SOURCE_DIR} CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${EDGEWISE_CCACHE})
endif()

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
