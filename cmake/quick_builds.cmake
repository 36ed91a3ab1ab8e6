# SPDX-License-Identifier: MIT
#
# What makes a build from nothing take fewer minutes, and the next one few.

# Where ccache is installed, what was compiled once is not compiled again, in another clone neither. It knows a
# compilation by its text, with names relative to the clone, by the compiler, and by what -march=native means here:
# another processor's objects are not taken. A precompiled header may come out of the cache too, so none holds a header
# of ours: as one of another clone it would not be recognised where it is included, and be there twice.
option(EDGEWISE_COMPILER_CACHE "Compile through ccache, where it is installed" ON)
find_program(EDGEWISE_CCACHE ccache)
mark_as_advanced(EDGEWISE_CCACHE)
if(PROJECT_IS_TOP_LEVEL AND EDGEWISE_COMPILER_CACHE AND EDGEWISE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(native ${PROJECT_BINARY_DIR}/native_options.txt)
    # In a folder that all clones have: clang says where it is asked.
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -x c++ -E -### /dev/null WORKING_DIRECTORY /
        OUTPUT_QUIET ERROR_VARIABLE options)
    file(CONFIGURE OUTPUT ${native} CONTENT "${options}" @ONLY)
    # An existing precompiled header would be read where the new one is made, and no other clone could use the result.
    # It is also newer than the files that include it, so that its content must decide.
    set(launcher ${PROJECT_BINARY_DIR}/compile_cached.sh)
    file(CONFIGURE OUTPUT ${launcher} CONTENT [[
before=
for word in "$@"; do
    case $before$word in -o*.gch | -o*.pch) rm -f "$word" ;; esac
    before=$word
done
export CCACHE_BASEDIR='@PROJECT_SOURCE_DIR@' CCACHE_NOHASHDIR=1 CCACHE_EXTRAFILES='@native@'
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
exec '@EDGEWISE_CCACHE@' "$@"
]] @ONLY)
    set(CMAKE_CXX_COMPILER_LAUNCHER sh ${launcher})
endif()

# edgewise_precompile(TARGET HEADER...): these headers of other projects, parsed once for all of the target's sources.
function(edgewise_precompile TARGET)
    target_precompile_headers(${TARGET} PRIVATE ${ARGN})
    target_compile_options(${TARGET} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# edgewise_unite(TARGET FILE...): compiles some of the sources at a time as one, which parses and instantiates once
# what they share; not these files, because their local names also occur in other files.
# Off where each file is needed by itself: with EDGEWISE_UNITY=OFF compile_commands.json has every file.
function(edgewise_unite TARGET)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ${EDGEWISE_UNITY} UNITY_BUILD_BATCH_SIZE 10)
    if(ARGN)
        set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
endfunction()
