# SPDX-License-Identifier: MIT
# The options of a build, and the flags that every file of Edgewise is compiled with.

option(EDGEWISE_TOOL "Build the profiling tool (else only the library)" ON)
option(EDGEWISE_MEASURE "Build edgewise::measure without the tool too" OFF)
option(EDGEWISE_TESTS "Build the tests" ON)
option(EDGEWISE_FULL_TESTS "The tests that only tests/run full has (docs/measuring.md)" OFF)
option(EDGEWISE_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(EDGEWISE_UNITY "Compile the tool's sources some at a time as one: a third of the time" ON)
option(EDGEWISE_PEERS "Build adapters of other libraries that are found, to measure these libraries too" OFF)
set(EDGEWISE_PEER_FOLDERS "" CACHE STRING "Where libraries for EDGEWISE_PEERS are that no package brings: folders that they are installed or built in")
set(EDGEWISE_LAYOUTS "" CACHE STRING "Only these layouts or table types (aos, aos_f64) of the manifest, for a quicker build; empty: all")
option(EDGEWISE_EVERY_LAYOUT "The program has all table types; else those of plan quick and for boxes, and tests have the others, compiled quickly" ON)
set(EDGEWISE_SIM_LAYOUTS "aos_f64;aos_f32;aos_mixed;lean_f64;lean_f32;lean_seeds_f64;lean_seeds_f32;points_soa_f64" CACHE STRING "Table types of edgewise_sim, the program for Valgrind")
set(EDGEWISE_TUNE "" CACHE STRING "Value for -march in the tool (native, x86-64-v3 ...); empty: the compiler's default")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

# The standard library checks indices, iterators and optionals in code that is not timed, for users too.
set(EDGEWISE_CHECKED _GLIBCXX_ASSERTIONS)

# Private to this build: warnings and sanitizers.
add_library(edgewise_flags INTERFACE)
target_compile_features(edgewise_flags INTERFACE cxx_std_20)
target_compile_options(edgewise_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    # False alarms of g++ 12 inside std::string (GCC bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
    # A compiler that rarely collects garbage: up to 9 % less time for a tenth more memory.
    "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1048576>"
    # The straight-line vectoriser of g++ 12 writes fused multiply-adds in spite of -ffp-contract=off.
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# Links a hundred tests in half the time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold EDGEWISE_HAS_GOLD)
if(EDGEWISE_HAS_GOLD)
    target_link_options(edgewise_flags INTERFACE -fuse-ld=gold)
endif()
if(EDGEWISE_SANITIZE)
    # The code of sanitizers hides initialisations from g++, which then warns inside the standard library.
    # The address sanitizer finds null and object-size anyway, and vptr has nothing to find here: they would triple the time
    # to compile. Alignment is only checked where bytes are laid out by hand: below, in tables.
    target_compile_options(edgewise_flags INTERFACE -fsanitize=address,undefined
        -fno-sanitize=null,object-size,vptr,alignment -fno-sanitize-recover=all
        -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(edgewise_flags INTERFACE -fsanitize=address,undefined)
    set(EDGEWISE_QUERY_LOOP_OPTIONS -fsanitize=alignment)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # Query loops are 10 to 20 % slower without it; house.no_contraction looks for products that it fuses.
    set(EDGEWISE_QUERY_LOOP_OPTIONS -ftree-slp-vectorize)
endif()
# Link it after edgewise_flags: the last of two contradicting options is used.
add_library(edgewise_query_loops INTERFACE)
target_compile_options(edgewise_query_loops INTERFACE ${EDGEWISE_QUERY_LOOP_OPTIONS})
