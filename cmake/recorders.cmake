# SPDX-License-Identifier: MIT
# The examples that record an engine, as programs next to the tool's: `edgewise record` calls them. An example is left out, with
# a message, if its engine is not found.
find_package(mujoco CONFIG QUIET)
find_package(Bullet QUIET)
find_package(sdformat12 CONFIG QUIET)

# edgewise_recorder(NAME FOUND PACKAGES LIBRARY...): the example record_NAME.
function(edgewise_recorder NAME FOUND PACKAGES)
    if(NOT FOUND)
        message(STATUS "edgewise: no recorder of ${NAME}, so `edgewise record` runs none of its models (Debian: ${PACKAGES})")
        return()
    endif()
    add_executable(record_${NAME} examples/record_${NAME}.cpp)
    target_compile_features(record_${NAME} PRIVATE cxx_std_20)
    target_include_directories(record_${NAME} PRIVATE ${EDGEWISE_INCLUDE})
    target_include_directories(record_${NAME} SYSTEM PRIVATE ${BULLET_INCLUDE_DIRS})
    target_link_libraries(record_${NAME} PRIVATE ${ARGN})
    set_target_properties(record_${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/recorders)
    add_dependencies(edgewise_program record_${NAME})
endfunction()
edgewise_recorder(mujoco "${mujoco_FOUND}" "libmujoco-dev libmujoco-samples" mujoco::mujoco)
edgewise_recorder(sdformat "${sdformat12_FOUND}" libsdformat-dev sdformat12::sdformat12)
edgewise_recorder(bullet "${BULLET_FOUND}" libbullet-dev ${BULLET_LIBRARIES})
