# SPDX-License-Identifier: MIT
# The golden answers on another processor: compiles answers.hpp for it by COMPILER with eight table types, and runs that by
# QEMU on the queries that the program QUESTIONS writes. Every row must be one of ANSWERS. Without -ffp-contract=off they must
# differ: else this test tests nothing. FULL: with -O3, too.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../consumer/steps.cmake)

set(flags -std=c++20 -DNDEBUG -I${SOURCE}/src -I${CMAKE_CURRENT_LIST_DIR} -isystem ${EIGEN} -fno-math-errno -Wno-psabi)
set(types aos_f64 aos_f32 aos_mixed lean_f64 lean_f32 lean_seeds_f64 points_soa_f64 points_soa_f32)
set(levels -O2)
if(FULL)
    list(APPEND levels -O3)
endif()
file(STRINGS ${ANSWERS} expected)
run("writing the queries" ${QUESTIONS} --questions ${SCRATCH}/queries.txt)

# The sources of the library that queries need, compiled once.
set(objects)
foreach(source algorithms/search/single_search geometry/strictly_convex geometry/hull/point_set geometry/hull/extreme_frame)
    string(MAKE_C_IDENTIFIER ${source} name)
    list(APPEND objects ${SCRATCH}/${name}.o)
    run("compiling ${source} for ${PROCESSOR}" ${COMPILER} ${flags} -O2 -ffp-contract=off
        -c ${SOURCE}/src/edgewise/${source}.cpp -o ${SCRATCH}/${name}.o)
endforeach()

# Compiles and runs a table type; sets ROWS to what it prints.
function(answer type level contraction)
    string(REGEX MATCH "^(.*)_(f64|f32|mixed)$" matched ${type})
    set(main ${SCRATCH}/${type}.cpp)
    file(WRITE ${main} "#include \"edgewise/layouts/${CMAKE_MATCH_1}.hpp\"
#include \"answers.hpp\"
int main(int, char** arguments) {
    using Table = edgewise::${CMAKE_MATCH_1}<edgewise::${CMAKE_MATCH_2}>;
    return edgewise::golden::print_rows<Table>(\"${type}\", arguments[1]) ? 0 : 1;
}
")
    run("compiling ${type} for ${PROCESSOR}" ${COMPILER} ${flags} ${level} -ffp-contract=${contraction} -static ${main}
        ${objects} -o ${SCRATCH}/${type})
    execute_process(COMMAND ${QEMU} ${SCRATCH}/${type} ${SCRATCH}/queries.txt OUTPUT_VARIABLE rows RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${PROCESSOR}, ${type} ${level}: ${failed} ${rows}")
    endif()
    string(REGEX REPLACE "\n$" "" rows "${rows}")
    string(REPLACE "\n" ";" rows "${rows}")
    set(ROWS ${rows} PARENT_SCOPE)
endfunction()

set(count 0)
foreach(level IN LISTS levels)
    foreach(type IN LISTS types)
        answer(${type} ${level} off)
        foreach(row IN LISTS ROWS)
            if(NOT row IN_LIST expected)
                message(SEND_ERROR "${PROCESSOR} ${level}: ${row} is not in ${ANSWERS}")
            endif()
            math(EXPR count "${count} + 1")
        endforeach()
    endforeach()
endforeach()
message(STATUS "${PROCESSOR}, ${levels}: ${count} hashes of answers compared")
answer(aos_f64 -O2 fast)
foreach(row IN LISTS ROWS)
    if(row IN_LIST expected)
        message(SEND_ERROR "${PROCESSOR}: fused products change no bit of ${row}")
    endif()
endforeach()
