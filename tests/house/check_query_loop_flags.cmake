# SPDX-License-Identifier: MIT
# Checks that query loops are compiled with their options, and that no later option reverses them.
# Variables: COMMANDS (compile_commands.json), OPTION (which must come last), OPPOSITE.
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
message(STATUS "${count} units of table types: ${OPTION} comes last")
