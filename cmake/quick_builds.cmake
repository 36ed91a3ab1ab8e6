# SPDX-License-Identifier: MIT
#
# Shortens builds: ccache, precompiled headers and unity builds.

# If ccache is installed, it keeps compiled objects, also for other clones. Its key is the preprocessed text with names
# relative to the clone, the compiler, and the options that -march=native expands to: objects of another processor are
# not used. Precompiled headers come from the cache too, so they contain no header of Edgewise: the compiler would not
# recognise a header of another clone, and would include it twice.
option(EDGEWISE_COMPILER_CACHE "Compile through ccache, where it is installed" ON)
find_program(EDGEWISE_CCACHE ccache)
mark_as_advanced(EDGEWISE_CCACHE)
if(PROJECT_IS_TOP_LEVEL AND EDGEWISE_COMPILER_CACHE AND EDGEWISE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(native ${PROJECT_BINARY_DIR}/native_options.txt)
    # In a folder that all clones have, because clang prints the working folder.
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -x c++ -E -### /dev/null WORKING_DIRECTORY /
        OUTPUT_QUIET ERROR_VARIABLE options)
    file(CONFIGURE OUTPUT ${native} CONTENT "${options}" @ONLY)
    # The compiler would read an existing precompiled header while it makes the new one, and no other clone could use the
    # result. It is also newer than the files that include it, so ccache must compare its content. clang's names files of its
    # build folder. Another clone does not have them, in a new folder they have another time: it is not cached.
    set(launcher ${PROJECT_BINARY_DIR}/compile_cached.sh)
    file(CONFIGURE OUTPUT ${launcher} CONTENT [[
before=
for word in "$@"; do
    case $before$word in
        -o*/cmake_pch*.pch) rm -f "$word"; exec "$@" ;;
        -o*.gch | -o*.pch) rm -f "$word" ;;
    esac
    before=$word
done
export CCACHE_BASEDIR='@PROJECT_SOURCE_DIR@' CCACHE_NOHASHDIR=1 CCACHE_EXTRAFILES='@native@'
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
exec '@EDGEWISE_CCACHE@' "$@"
]] @ONLY)
    set(CMAKE_CXX_COMPILER_LAUNCHER sh ${launcher})
endif()

# edgewise_precompile(TARGET HEADER...): parses these headers of other projects once for all of the target's sources.
function(edgewise_precompile TARGET)
    target_precompile_headers(${TARGET} PRIVATE ${ARGN})
    target_compile_options(${TARGET} PRIVATE
        $<IF:$<CXX_COMPILER_ID:GNU>,-fpch-preprocess,SHELL:-Xclang -fno-pch-timestamp>)
endfunction()

# edgewise_unite(TARGET FILE...): compiles groups of sources as one, which parses and instantiates their common
# headers once. These files stay separate, because their local names also occur in other files.
# With EDGEWISE_UNITY=OFF each file is compiled by itself, and compile_commands.json has every file.
function(edgewise_unite TARGET)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ${EDGEWISE_UNITY} UNITY_BUILD_BATCH_SIZE 10)
    if(ARGN)
        set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
endfunction()
