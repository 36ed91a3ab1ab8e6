# SPDX-License-Identifier: MIT
# Compiles and runs sanitized/queries.cpp under sanitizers, as a user's CI does: with each of COMPILERS, LEVELS and
# SANITIZERS, POSES poses on 8 and on 400 vertices. A report, or no agreement of its answers, fails.
foreach(compiler IN LISTS COMPILERS)
    foreach(level IN LISTS LEVELS)
        foreach(sanitizer IN LISTS SANITIZERS)
            string(TIMESTAMP started %s)
            execute_process(COMMAND ${compiler} -std=c++20 ${level} -g1 -ffp-contract=off -fsanitize=${sanitizer}
                -fno-sanitize-recover=all -I${SOURCE}/src -I${EIGEN} ${SOURCE}/tests/consumer/sanitized/queries.cpp
                ${LIBRARY} -lqhull_r -o ${SCRATCH}/queries RESULT_VARIABLE code ERROR_VARIABLE said)
            if(NOT code EQUAL 0)
                message(FATAL_ERROR "${compiler} ${level} ${sanitizer} does not compile:\n${said}")
            endif()
            string(TIMESTAMP compiled %s)
            foreach(vertices 8 400)
                execute_process(COMMAND ${SCRATCH}/queries ${vertices} ${POSES} RESULT_VARIABLE code
                    OUTPUT_VARIABLE sums ERROR_VARIABLE said)
                if(NOT code EQUAL 0)
                    message(FATAL_ERROR "${compiler} ${level} ${sanitizer}, ${vertices} vertices: ${sums}\n${said}")
                endif()
            endforeach()
            math(EXPR seconds "${compiled} - ${started}")
            message(STATUS "${compiler} ${level} ${sanitizer}: quiet, ${seconds} s to compile; ${sums}")
        endforeach()
    endforeach()
endforeach()
