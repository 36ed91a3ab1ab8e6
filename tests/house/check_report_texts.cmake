# SPDX-License-Identifier: MIT
# cmake -D ROOT=<tree> -D FOLDER=<scratch> -D GENERATOR=<name> -P check_report_texts.cmake
# What a sweep writes to reports/out is no text of the report: a tree that a sweep has run in configures again. A small
# project with a text and a sweep's output of the same name, configured by the tree's own cmake/report_texts.cmake; and
# the control, two texts of one name, which must be an error still.
function(write_project)
    file(REMOVE_RECURSE ${FOLDER})
    file(WRITE ${FOLDER}/CMakeLists.txt "cmake_minimum_required(VERSION 3.22)
project(swept NONE)
include(${ROOT}/cmake/report_texts.cmake)
edgewise_write_report_texts(\${PROJECT_BINARY_DIR}/texts.cpp)
")
    file(COPY ${ROOT}/cmake/report_texts.cpp.in DESTINATION ${FOLDER}/cmake)
    file(WRITE ${FOLDER}/reports/text/times.md "prose\n")
endfunction()

function(configure RESULT ERROR)
    execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${FOLDER} -B ${FOLDER}/build
        RESULT_VARIABLE result ERROR_VARIABLE error OUTPUT_QUIET)
    set(${RESULT} ${result} PARENT_SCOPE)
    string(REGEX REPLACE "[ \n]+" " " error "${error}")  # as it was before it was broken into lines
    set(${ERROR} "${error}" PARENT_SCOPE)
endfunction()

write_project()
file(WRITE ${FOLDER}/reports/out/times.md "measured\n")
file(WRITE ${FOLDER}/reports/out/charts/time.vl.json "{}\n")
configure(result error)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "a tree with reports/out does not configure: leave it out in cmake/report_texts.cmake\n${error}")
endif()
file(READ ${FOLDER}/build/texts.cpp texts)
if(NOT texts MATCHES "prose" OR texts MATCHES "measured|time[.]vl")
    message(FATAL_ERROR "the report's texts are not those outside reports/out:\n${texts}")
endif()

write_project()
file(WRITE ${FOLDER}/reports/paper/text/times.md "other prose\n")
configure(result error)
if(result EQUAL 0 OR NOT error MATCHES "another report text is called times.md")
    message(FATAL_ERROR "two texts of one name are no error: this check would see nothing\n${error}")
endif()
file(REMOVE_RECURSE ${FOLDER})
