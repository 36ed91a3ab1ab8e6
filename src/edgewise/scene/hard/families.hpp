// SPDX-License-Identifier: MIT
//
// The hard-case families: seeded generators of pairs that broke some collision library, each with the regime
// it sweeps, and six rows of cube poses on which the original V-Clip was measured. One line per family in
// families.cpp; the generators are in files named after the property that they vary.
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
    std::function<hard::Pair(hard::Maker&)> make;
    bool warm = false;  ///< the poses of a pair follow each other, and its cache is kept
};

/// In the order of the report.
[[nodiscard]] std::span<const HardFamily> hard_families();

namespace hard {

using Family = Pair(Maker&);

Family parallel_faces, near_parallel_faces, near_parallel_edges, voronoi_straddle, noisy_rotation;
Family grazing, exact_touch, deep_and_concentric, tie_rich_solids;
Family slivers_and_needles, scale_disparity, absolute_scale, large_offset, far_apart, extreme_numbers;
Family duplicates, near_coplanar_vertices, flat_bodies, thin_beams, random_fuzz, real_hulls_at_gaps;
Family thin_bodies, thin_bodies_in_motion, coherent_motion, bad_warm_start;
Family cubes_random, cubes_near_parallel, cubes_half_lattice, cubes_identical_pose, cubes_45_degrees,
    cubes_quarter_turns;

}  // namespace hard

}  // namespace edgewise::scene
