# SPDX-License-Identifier: MIT
# The scene files that come with Edgewise become text in the program: it finds them wherever it is installed.

# edgewise_scene(NAME): the file NAME.json beside the manifest.
function(edgewise_scene NAME)
    set(file ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}.json)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    set_property(GLOBAL APPEND_STRING PROPERTY EDGEWISE_SCENES "    {\"${NAME}\", R\"json(${text})json\"},\n")
endfunction()

function(edgewise_write_scenes)
    get_property(SCENES GLOBAL PROPERTY EDGEWISE_SCENES)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/scene_texts.cpp.in ${PROJECT_BINARY_DIR}/registry/scene_texts.cpp @ONLY)
endfunction()
