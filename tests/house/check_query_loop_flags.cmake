# SPDX-License-Identifier: MIT
# Query loops are compiled with the options that are meant for them, not with what an option behind them takes back.
# Variables: COMMANDS (compile_commands.json), OPTION (that must come last), OPPOSITE.
file(STRINGS ${COMMANDS} commands REGEX "\"command\".*tool_table_types[.]dir/(registry/.*_f64|Unity/unity_)")
list(LENGTH commands count)
if(count EQUAL 0)
    message(FATAL_ERROR "no table type in ${COMMANDS}: was it written by another build?")
endif()
foreach(command IN LISTS commands)
    if(NOT command MATCHES " ${OPTION} " OR command MATCHES " ${OPTION} .* ${OPPOSITE} ")
        message(FATAL_ERROR "compiled without ${OPTION}, or with ${OPPOSITE} behind it: ${command}")
    endif()
endforeach()
message(STATUS "${count} units of table types: ${OPTION} is the last word")
