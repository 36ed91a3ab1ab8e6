# SPDX-License-Identifier: MIT
# Compiles UNIT, which must fail with exactly one error: the text after "// error: " in UNIT.
file(READ ${UNIT} text)
string(REGEX MATCH "// error: ([^\n]*)" wanted "${text}")
set(wanted ${CMAKE_MATCH_1})
execute_process(COMMAND ${COMMAND} ${UNIT} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
string(REGEX MATCHALL "error: [^\n]*" errors "${said}")
list(LENGTH errors count)
if(code EQUAL 0 OR NOT count EQUAL 1 OR NOT errors MATCHES "${wanted}")
    message(FATAL_ERROR "expected one error, '${wanted}'; got ${count}:\n${said}")
endif()
message(STATUS "${errors}")
