# SPDX-License-Identifier: MIT
# libpfm4 knows the processors' own names of their events. Without it only the kernel's generic events are counted.
find_path(LIBPFM_INCLUDE_DIR perfmon/pfmlib_perf_event.h)
find_library(LIBPFM_LIBRARY pfm)
if(LIBPFM_INCLUDE_DIR AND LIBPFM_LIBRARY)
    set(EDGEWISE_LIBPFM_LIBRARY ${LIBPFM_LIBRARY})
else()
    message(STATUS "edgewise: no libpfm, so only the kernel's generic events are counted (Debian: libpfm4-dev)")
    set(EDGEWISE_LIBPFM_LIBRARY "")
endif()
