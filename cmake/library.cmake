# SPDX-License-Identifier: MIT
# No version in the call: Eigen 5 does not accept a request for 3.4.
find_package(Eigen3 REQUIRED NO_MODULE)
if(Eigen3_VERSION VERSION_LESS 3.4)
    message(FATAL_ERROR "edgewise: Eigen ${Eigen3_VERSION} is too old: 3.4 or newer is needed (Debian: libeigen3-dev)")
endif()
find_package(Qhull REQUIRED NO_MODULE)

edgewise_sources(sources src/edgewise/geometry src/edgewise/algorithms)
add_library(edgewise_library STATIC ${sources})
add_library(edgewise::edgewise ALIAS edgewise_library)
set_target_properties(edgewise_library PROPERTIES EXPORT_NAME edgewise OUTPUT_NAME edgewise POSITION_INDEPENDENT_CODE ON)
target_compile_features(edgewise_library PUBLIC cxx_std_20)
# V-Clip needs two equal products to be the same number; with contraction the compiler could fuse only one of them.
target_compile_options(edgewise_library PUBLIC $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-ffp-contract=off>)
target_compile_definitions(edgewise_library PUBLIC EDGEWISE_CONTRACTION_KNOWN)  # else headers warn where products may be fused
target_include_directories(edgewise_library PUBLIC
    $<BUILD_INTERFACE:${EDGEWISE_INCLUDE}> $<INSTALL_INTERFACE:include>)
target_link_libraries(edgewise_library PUBLIC Eigen3::Eigen PRIVATE Qhull::qhull_r $<BUILD_INTERFACE:edgewise_flags>)
# Mutants (tests/mutation) replace the first file. The second has registers wider than the machine's, which are only arguments
# of inlined functions; without errno it takes the roots of all lanes at once.
edgewise_unite(edgewise_library src/edgewise/geometry/strictly_convex.cpp src/edgewise/algorithms/search/single_search.cpp)
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/edgewise/algorithms/search/single_search.cpp PROPERTIES
    COMPILE_OPTIONS "-Wno-psabi;-fno-math-errno" SKIP_PRECOMPILE_HEADERS ON)
edgewise_precompile(edgewise_library <Eigen/Core> <algorithm> <functional> <string> <vector>)
