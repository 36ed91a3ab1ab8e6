# SPDX-License-Identifier: MIT
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Qhull REQUIRED NO_MODULE)

add_library(edgewise_library STATIC
    src/algorithms/sweep_and_prune.cpp
    src/geometry/check_polyhedron.cpp
    src/geometry/check_topology.cpp
    src/geometry/extreme_frame.cpp
    src/geometry/face_plane.cpp
    src/geometry/face_shape.cpp
    src/geometry/faces.cpp
    src/geometry/flat_hull.cpp
    src/geometry/grid.cpp
    src/geometry/hull.cpp
    src/geometry/point_set.cpp
    src/geometry/polyhedron.cpp
    src/geometry/strictly_convex.cpp
    src/geometry/polyhedron_builder.cpp
    src/geometry/qhull_facets.cpp
    src/geometry/vertex_order.cpp)
add_library(edgewise::edgewise ALIAS edgewise_library)
set_target_properties(edgewise_library PROPERTIES EXPORT_NAME edgewise OUTPUT_NAME edgewise POSITION_INDEPENDENT_CODE ON)
target_compile_features(edgewise_library PUBLIC cxx_std_20)
# Contraction would let the compiler fuse one of two products that V-Clip relies on being the same number.
target_compile_options(edgewise_library PUBLIC $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
target_include_directories(edgewise_library PUBLIC
    $<BUILD_INTERFACE:${EDGEWISE_INCLUDE}> $<INSTALL_INTERFACE:include>)
target_link_libraries(edgewise_library PUBLIC Eigen3::Eigen PRIVATE Qhull::qhull_r $<BUILD_INTERFACE:edgewise_flags>)
