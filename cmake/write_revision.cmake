# SPDX-License-Identifier: MIT
# Run at every build: the revision may have changed since the last configure. Writes the file only if it differs.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12
                OUTPUT_VARIABLE REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    set(REVISION "unknown (not a git checkout)")
elseif(REVISION MATCHES "-dirty$")
    # Two different edits of one revision are two builds: name the edit.
    execute_process(COMMAND git -C ${SOURCE} diff HEAD OUTPUT_VARIABLE edit)
    string(SHA1 edit "${edit}")
    string(SUBSTRING ${edit} 0 8 edit)
    string(APPEND REVISION "-${edit}")
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
