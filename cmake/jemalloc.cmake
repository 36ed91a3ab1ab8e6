# SPDX-License-Identifier: MIT
# jemalloc next to the C library's malloc, not instead of it: its archive is linked into one object, and all symbols
# except those of its own interface are made local to it. Loading the shared library instead fails: its thread-local
# storage must be there from the program's start.
set(EDGEWISE_JEMALLOC_OBJECT "")
find_path(JEMALLOC_INCLUDE_DIR jemalloc/jemalloc.h)
find_library(JEMALLOC_ARCHIVE libjemalloc_pic.a)
if(EDGEWISE_SANITIZE)
    # Sanitizers have their own malloc.
elseif(JEMALLOC_INCLUDE_DIR AND JEMALLOC_ARCHIVE AND CMAKE_OBJCOPY AND CMAKE_LINKER)
    set(EDGEWISE_JEMALLOC_OBJECT ${PROJECT_BINARY_DIR}/jemalloc_apart.o)
    set(visible mallocx sdallocx nallocx mallctl)
    list(TRANSFORM visible PREPEND --keep-global-symbol=)
    add_custom_command(OUTPUT ${EDGEWISE_JEMALLOC_OBJECT} DEPENDS ${JEMALLOC_ARCHIVE} VERBATIM
        COMMAND ${CMAKE_LINKER} -r -o ${PROJECT_BINARY_DIR}/jemalloc_whole.o
                --whole-archive ${JEMALLOC_ARCHIVE} --no-whole-archive
        COMMAND ${CMAKE_OBJCOPY} ${visible} ${PROJECT_BINARY_DIR}/jemalloc_whole.o ${EDGEWISE_JEMALLOC_OBJECT})
    set_source_files_properties(${EDGEWISE_JEMALLOC_OBJECT} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
else()
    message(STATUS "edgewise: no jemalloc, so tables come from the arena and the C library only (Debian: libjemalloc-dev)")
endif()
