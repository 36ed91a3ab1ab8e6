# SPDX-License-Identifier: MIT
# Where ccache is installed, what was compiled once is not compiled again, in another clone neither. It knows a
# compilation by its text, with names relative to the clone, by the compiler, and by what -march=native means here:
# another processor's objects are not taken. A precompiled header may come out of the cache too, so none holds a header
# of ours: as one of another clone it would not be recognised where it is included, and be there twice.
option(EDGEWISE_COMPILER_CACHE "Compile through ccache, where it is installed" ON)
find_program(EDGEWISE_CCACHE ccache)
mark_as_advanced(EDGEWISE_CCACHE)
if(NOT PROJECT_IS_TOP_LEVEL OR NOT EDGEWISE_COMPILER_CACHE OR NOT EDGEWISE_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
    return()
endif()
set(native ${PROJECT_BINARY_DIR}/native_options.txt)
# In a folder that all clones have: clang says where it is asked.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -x c++ -E -### /dev/null WORKING_DIRECTORY /
    OUTPUT_QUIET ERROR_VARIABLE options)
file(CONFIGURE OUTPUT ${native} CONTENT "${options}" @ONLY)
set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_EXTRAFILES=${native}
    # Precompiled headers are newer than what includes them; their content tells.
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    ${EDGEWISE_CCACHE})
