# SPDX-License-Identifier: MIT
# cmake -D ROOT=<tree> -D FOLDER=<scratch> -D GENERATOR=<name> -P check_report_texts.cmake
# Output of a sweep in reports/out is not a text of the report, so CMake must configure a tree after a sweep. Configures a small
# project that has a text and a sweep's output of the same name, with the tree's own cmake/report_texts.cmake. As a control,
# two texts of one name must still be an error.
file(REMOVE_RECURSE ${FOLDER})
file(WRITE ${FOLDER}/CMakeLists.txt "cmake_minimum_required(VERSION 3.22)
project(swept NONE)
include(${ROOT}/cmake/report_texts.cmake)
edgewise_write_report_texts(\${PROJECT_BINARY_DIR}/texts.cpp)
")
file(COPY ${ROOT}/cmake/report_texts.cpp.in DESTINATION ${FOLDER}/cmake)
file(WRITE ${FOLDER}/reports/text/times.md "prose\n")
file(WRITE ${FOLDER}/reports/out/times.md "measured\n")
file(WRITE ${FOLDER}/reports/out/charts/time.vl.json "{}\n")
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -S ${FOLDER} -B ${FOLDER}/build)
execute_process(COMMAND ${configure} RESULT_VARIABLE result ERROR_VARIABLE error OUTPUT_QUIET)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "a tree with reports/out does not configure: leave it out in cmake/report_texts.cmake\n${error}")
endif()
file(READ ${FOLDER}/build/texts.cpp texts)
if(NOT texts MATCHES "prose" OR texts MATCHES "measured|time[.]vl")
    message(FATAL_ERROR "the report's texts are not those outside reports/out:\n${texts}")
endif()

file(WRITE ${FOLDER}/reports/paper/text/times.md "other prose\n")
execute_process(COMMAND ${configure} RESULT_VARIABLE result ERROR_VARIABLE error OUTPUT_QUIET)
string(REGEX REPLACE "[ \n]+" " " error "${error}")  # undo CMake's line breaks
if(result EQUAL 0 OR NOT error MATCHES "another report text is called times.md")
    message(FATAL_ERROR "two texts of one name are not an error: this check would find nothing\n${error}")
endif()
file(REMOVE_RECURSE ${FOLDER})
