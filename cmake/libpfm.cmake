# SPDX-License-Identifier: MIT
# libpfm4 knows the names of processors' events. Without it no event of the processor is counted.
find_path(LIBPFM_INCLUDE_DIR perfmon/pfmlib_perf_event.h)
find_library(LIBPFM_LIBRARY pfm)
if(LIBPFM_INCLUDE_DIR AND LIBPFM_LIBRARY)
    set(EDGEWISE_LIBPFM_LIBRARY ${LIBPFM_LIBRARY})
else()
    message(STATUS "edgewise: no libpfm, so no event of the processor is counted (Debian: libpfm4-dev)")
    set(EDGEWISE_LIBPFM_LIBRARY "")
endif()
