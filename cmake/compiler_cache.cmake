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
