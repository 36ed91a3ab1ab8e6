# SPDX-License-Identifier: MIT
# check_contraction.cmake with TOOL and PROGRAM: no packed fused multiply-add anywhere. A fused one rounds once
# where every other build rounds twice: another answer on another machine.
execute_process(COMMAND ${TOOL} --disassemble --no-show-raw-insn ${PROGRAM} RESULT_VARIABLE result OUTPUT_VARIABLE code)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${TOOL} cannot read ${PROGRAM}")
endif()
string(REGEX MATCHALL "\t(mul|vmul)[sp][sd] " products "${code}")
list(LENGTH products product_count)
if(product_count LESS 1000)
    message(FATAL_ERROR "only ${product_count} products found in ${PROGRAM}: the disassembly is not understood")
endif()
string(REGEX MATCHALL "vfn?m(add|sub)[a-z]*[0-9]+p[sd]" fused "${code}")
if(fused)
    list(LENGTH fused count)
    list(REMOVE_DUPLICATES fused)
    message(FATAL_ERROR "${count} contracted by the compiler: ${fused}")
endif()
message("${product_count} products, none fused by the compiler")
