# SPDX-License-Identifier: MIT
#
# edgewise_fetch_charts(): puts the chart bundles and the picture renderer into <build>/charts at configure time and
# sets EDGEWISE_CHARTS_DIR to that directory. Never fatal: without npm or a network the report shows tables.
function(edgewise_fetch_charts)
    set(directory "${CMAKE_BINARY_DIR}/charts")
    set(reports "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../reports/page")
    file(MAKE_DIRECTORY "${directory}")
    configure_file("${reports}/render_svg.mjs" "${directory}/render_svg.mjs" COPYONLY)
    execute_process(
        COMMAND sh "${reports}/fetch_charts.sh" "${directory}"
        RESULT_VARIABLE result
        ERROR_VARIABLE message
        ERROR_STRIP_TRAILING_WHITESPACE)
    if(result EQUAL 0)
        message(STATUS "charts: bundles are in ${directory}")
    else()
        message(STATUS "${message}")
    endif()
    set(EDGEWISE_CHARTS_DIR "${directory}" PARENT_SCOPE)
endfunction()
