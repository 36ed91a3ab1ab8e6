// SPDX-License-Identifier: MIT
//
// The hard-case families: seeded generators of pairs that broke some collision library, each with the regime
// it sweeps, and six rows of cube poses on which the original V-Clip was measured. One line per family in
// families.cpp; the generators stand in the files named after what they vary.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/scene/hard/maker.hpp"

namespace edgewise::scene {

struct HardFamily {
    std::string name;
    std::string varies;  ///< one line
    std::string breaks;  ///< what such pairs broke elsewhere
    bool warm = false;   ///< the poses of a pair follow each other, and its cache is kept
    std::function<hard::Pair(hard::Maker&)> make;
};

/// In the order of the report.
[[nodiscard]] std::span<const HardFamily> hard_families();

namespace hard {

// parallel.cpp
[[nodiscard]] Pair parallel_faces(Maker& maker);
[[nodiscard]] Pair near_parallel_faces(Maker& maker);
[[nodiscard]] Pair near_parallel_edges(Maker& maker);
[[nodiscard]] Pair voronoi_straddle(Maker& maker);
[[nodiscard]] Pair noisy_rotation(Maker& maker);
// contact.cpp
[[nodiscard]] Pair grazing(Maker& maker);
[[nodiscard]] Pair exact_touch(Maker& maker);
[[nodiscard]] Pair deep_and_concentric(Maker& maker);
[[nodiscard]] Pair tie_rich_solids(Maker& maker);
// size.cpp
[[nodiscard]] Pair slivers_and_needles(Maker& maker);
[[nodiscard]] Pair scale_disparity(Maker& maker);
[[nodiscard]] Pair absolute_scale(Maker& maker);
[[nodiscard]] Pair large_offset(Maker& maker);
[[nodiscard]] Pair far_apart(Maker& maker);
[[nodiscard]] Pair extreme_numbers(Maker& maker);
// bodies.cpp
[[nodiscard]] Pair duplicates(Maker& maker);
[[nodiscard]] Pair near_coplanar_vertices(Maker& maker);
[[nodiscard]] Pair flat_bodies(Maker& maker);
[[nodiscard]] Pair thin_beams(Maker& maker);
[[nodiscard]] Pair random_fuzz(Maker& maker);
[[nodiscard]] Pair real_hulls_at_gaps(Maker& maker);
// sequences.cpp
[[nodiscard]] Pair coherent_motion(Maker& maker);
[[nodiscard]] Pair bad_warm_start(Maker& maker);
// cubes.cpp
[[nodiscard]] Pair cubes_random(Maker& maker);
[[nodiscard]] Pair cubes_near_parallel(Maker& maker);
[[nodiscard]] Pair cubes_half_lattice(Maker& maker);
[[nodiscard]] Pair cubes_identical_pose(Maker& maker);
[[nodiscard]] Pair cubes_45_degrees(Maker& maker);
[[nodiscard]] Pair cubes_quarter_turns(Maker& maker);

}  // namespace hard

}  // namespace edgewise::scene
