# SPDX-License-Identifier: MIT
# The scene files and plans that come with Edgewise become text in the program, so that it finds them wherever it is installed.

function(edgewise_embed PROPERTY NAME FILE)
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FILE})
    file(READ ${FILE} text)
    set_property(GLOBAL APPEND_STRING PROPERTY ${PROPERTY} "        {\"${NAME}\", R\"json(${text})json\"},\n")
endfunction()

# edgewise_scene(NAME): the file NAME.json in the manifest's folder.
function(edgewise_scene NAME)
    edgewise_embed(EDGEWISE_SCENES ${NAME} ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}.json)
endfunction()

# edgewise_plan(NAME FILE): a plan of that name, in a file in the manifest's folder.
function(edgewise_plan NAME FILE)
    edgewise_embed(EDGEWISE_PLANS ${NAME} ${CMAKE_CURRENT_SOURCE_DIR}/${FILE})
endfunction()

# Call it after all manifests.
function(edgewise_write_scenes)
    get_property(SCENES GLOBAL PROPERTY EDGEWISE_SCENES)
    get_property(PLANS GLOBAL PROPERTY EDGEWISE_PLANS)
    foreach(texts scene_texts plan_texts)
        configure_file(${PROJECT_SOURCE_DIR}/cmake/${texts}.cpp.in ${PROJECT_BINARY_DIR}/registry/${texts}.cpp @ONLY)
    endforeach()
endfunction()
