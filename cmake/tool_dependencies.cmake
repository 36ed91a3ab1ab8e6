# SPDX-License-Identifier: MIT
# What the tool needs beyond the library. Debian names: libgmp-dev libsqlite3-dev nlohmann-json3-dev libcli11-dev
# libfmt-dev libtbb-dev libassimp-dev zlib1g-dev.
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(TBB REQUIRED)
find_package(ZLIB REQUIRED)
find_library(GMP_LIBRARY gmp REQUIRED)
find_library(GMPXX_LIBRARY gmpxx REQUIRED)

find_package(assimp QUIET)
if(NOT assimp_FOUND)
    message(STATUS "edgewise: Assimp not found, so mesh files cannot be read (Debian: libassimp-dev)")
endif()
