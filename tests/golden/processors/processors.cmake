# SPDX-License-Identifier: MIT
# The golden answers on another processor: compiles answers.hpp for it by COMPILER with each of the table types O2 and O3, at
# this level and with OPTIONS, and runs that by QEMU on the queries that the program QUESTIONS writes. A type's rows must be
# those of ANSWERS. Without -ffp-contract=off its answers must differ: else this test tests nothing.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../../consumer/steps.cmake)

set(flags -std=c++20 -DNDEBUG -I${SOURCE}/src -I${CMAKE_CURRENT_LIST_DIR} -isystem ${EIGEN} -fno-math-errno -Wno-psabi
    -DEDGEWISE_CONTRACTION_KNOWN)
file(STRINGS ${ANSWERS} expected)

# The sources of the library that queries need, compiled once. No query builds hulls: the linker drops functions that do.
set(objects)
foreach(source algorithms/search/single_search geometry/strictly_convex geometry/hull/point_set geometry/hull/extreme_frame
        geometry/grid)
    string(MAKE_C_IDENTIFIER ${source} name)
    list(APPEND objects ${SCRATCH}/${name}.o)
    run("compiling ${source} for ${PROCESSOR}" ${COMPILER} ${flags} -O2 -ffp-contract=off -ffunction-sections
        -c ${SOURCE}/src/edgewise/${source}.cpp -o ${SCRATCH}/${name}.o)
endforeach()

# Compiles a table type and runs it on its queries; sets ROWS to what it prints.
function(answer type level contraction)
    string(REGEX REPLACE "(_seeds)[0-9]+_" "\\1_" file ${type})
    string(REGEX REPLACE "_[^_]*$" ".hpp" file ${file})
    string(REGEX MATCH "^(.*)_([^_]*)$" matched ${type})
    set(main ${SCRATCH}/${type}.cpp)
    file(WRITE ${main} "#include \"edgewise/layouts/${file}\"
#include \"answers.hpp\"
int main(int, char** arguments) {
    using Table = edgewise::${CMAKE_MATCH_1}<edgewise::${CMAKE_MATCH_2}>;
    return edgewise::golden::print_rows<Table>(\"${type}\", arguments[1]) ? 0 : 1;
}
")
    run("writing the queries of ${type}" ${QUESTIONS} --questions ${SCRATCH}/queries.txt ${type})
    run("compiling ${type} for ${PROCESSOR}" ${COMPILER} ${flags} ${OPTIONS} ${level} -ffp-contract=${contraction} -static
        -Wl,--gc-sections ${main} ${objects} -o ${SCRATCH}/${type})
    execute_process(COMMAND ${QEMU} ${SCRATCH}/${type} ${SCRATCH}/queries.txt OUTPUT_VARIABLE rows RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${PROCESSOR}, ${type} ${level}: ${failed} ${rows}")
    endif()
    string(REGEX REPLACE "\n$" "" rows "${rows}")
    string(REPLACE "\n" ";" rows "${rows}")
    list(SORT rows)
    set(ROWS ${rows} PARENT_SCOPE)
endfunction()

set(count 0)
foreach(level O2 O3)
    foreach(type IN LISTS ${level})
        answer(${type} -${level} off)
        set(rows ${expected})
        list(FILTER rows INCLUDE REGEX "^((bytes|corpus|pairs) )?${type} ")
        if(NOT ROWS STREQUAL rows)
            message(SEND_ERROR "${PROCESSOR} -${level}: ${ROWS}\nand on x86-64: ${rows}")
        endif()
        list(LENGTH rows added)
        math(EXPR count "${count} + ${added}")
    endforeach()
endforeach()
message(STATUS "${PROCESSOR}, -O2: ${O2}; -O3: ${O3}: ${count} hashes of answers and bytes compared")
# Control: where the compiler may fuse products, answers differ.
set(ROWS)
if("aos_f64" IN_LIST O2)
    answer(aos_f64 -O2 fast)
endif()
foreach(row IN LISTS ROWS)
    if(row IN_LIST expected AND NOT row MATCHES "^bytes ")
        message(SEND_ERROR "${PROCESSOR}: fused products change no bit of ${row}")
    endif()
endforeach()
