# SPDX-License-Identifier: MIT
# The report's prose (*.md), the frame of its page, chart specifications (*.vl.json), and claims become text in the program,
# so that it finds them wherever it is installed. A name without its folders identifies a text, so two files of one name
# are an error.

# edgewise_write_report_texts(OUTPUT): writes the source file OUTPUT.
function(edgewise_write_report_texts OUTPUT)
    set(reports ${PROJECT_SOURCE_DIR}/reports)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS ${reports}/*.vl.json ${reports}/*.md ${reports}/text/page/page.*
        ${reports}/paper/text/*.json ${reports}/paper/claims/*.json)
    list(FILTER files EXCLUDE REGEX "^${reports}/out/")  # what sweeps write
    list(SORT files)
    set(TEXTS)
    set(names)
    foreach(file IN LISTS files)
        get_filename_component(name ${file} NAME)
        if(name IN_LIST names)
            message(FATAL_ERROR "edgewise: ${file}: another report text is called ${name}: rename one of them")
        endif()
        list(APPEND names ${name})
        set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
        file(READ ${file} text)
        string(APPEND TEXTS "    {\"${name}\", R\"text(${text})text\"},\n")
        if(name MATCHES "^page.*[.]js$")  # by which the page's policy knows its own scripts
            string(SHA256 digest "${text}")
            string(APPEND TEXTS "    {\"${name}.sha256\", \"${digest}\"},\n")
        endif()
    endforeach()
    configure_file(${PROJECT_SOURCE_DIR}/cmake/report_texts.cpp.in ${OUTPUT} @ONLY)
endfunction()
