// SPDX-License-Identifier: MIT
#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene {

namespace {

using namespace hard;

const std::vector<HardFamily> all = {
    {"parallel_faces", "boxes and prisms of one orientation, face gap 0 or +-2^-k, aligned offsets",
     "ties: the closest points are not unique", parallel_faces},
    {"near_parallel_faces", "as before, one tilted by 2^-52 to 2^-4 rad",
     "flat triangles and tetrahedra, the direction of a short difference", near_parallel_faces},
    {"near_parallel_edges", "rolled beams that cross at 0 to 1/2 rad, ridge gap +-2^-40 to 2^-4",
     "closest points of edges by 1 - k^2; V-Clip's edge-edge cycle", near_parallel_edges},
    {"grazing", "any pair moved to a gap of some rounding steps, either sign", "verdicts, NaN normals",
     grazing},
    {"exact_touch", "dyadic boxes that touch: vertices, edges, faces, in all combinations",
     "open against closed sets, 0 / 0", exact_touch},
    {"slivers_and_needles", "triangles, boxes and tetrahedra of aspect up to 10^8",
     "signed volumes, normals of short edges", slivers_and_needles},
    {"scale_disparity", "bodies of size ratio up to 10^8, resting, grazing, sunk",
     "absolute tolerances, cancellation in support products", scale_disparity},
    {"absolute_scale", "whole scenes times 2^k, |k| <= 60 (20 in single)",
     "absolute epsilons on squared lengths, overflow of products", absolute_scale},
    {"large_offset", "both bodies up to 10^12 sizes (10^6 in single) from the origin, by pose or by vertices",
     "digits lost before the subtraction", large_offset},
    {"far_apart", "gaps up to 10^8 sizes", "progress tests relative to the distance", far_apart},
    {"duplicates", "copied and nearly copied vertices, a body on itself",
     "supports that return the old point, edges of length zero", duplicates},
    {"near_coplanar_vertices", "prisms of 3 to 64 sides, split and noisy cube faces, points within faces",
     "plateaus of hill climbing, Voronoi regions of no width", near_coplanar_vertices},
    {"flat_bodies", "points, segments, triangles and polygons against each other and against solids",
     "no simplex with a volume exists", flat_bodies},
    {"deep_and_concentric", "one body inside the other, centres equal or nearly",
     "zero first direction, depth ties, V-Clip's local minimum", deep_and_concentric},
    {"tie_rich_solids", "cubes, octahedra, icosahedra, cylinders over each other's vertices and edges",
     "equal support values", tie_rich_solids},
    {"voronoi_straddle", "the closest point on a Voronoi plane, or slightly off it", "states that flip",
     voronoi_straddle},
    {"coherent_motion", "sliding at a constant gap, rolling, oscillation across contact, with the cache kept",
     "stale caches, cycles", coherent_motion, true},
    {"bad_warm_start", "every pose unrelated to the one before, with the cache kept",
     "local minima, wrong verdicts from a warm start", bad_warm_start, true},
    {"noisy_rotation", "rotation matrices off by 1e-16 to 1e-4", "Voronoi planes not orthogonal",
     noisy_rotation},
    {"extreme_numbers", "denormal, tiny and huge coordinates, minus zero",
     "underflow and overflow of products", extreme_numbers},
    {"thin_beams", "beams 10 times as long as thick, far from their own origin", "disagreeing verdicts",
     thin_beams},
    {"random_fuzz", "cubes, slabs, needles and random hulls at random places", "what nobody thought of",
     random_fuzz},
    {"real_hulls_at_gaps", "hulls of real objects at gaps of 5 to 1e-12 sizes, and as deep",
     "a realistic mix", real_hulls_at_gaps},
    {"thin_bodies", "bodies 1e-11 to 1e-5 of their extent thick, in one plane, crossing, anywhere near",
     "separated along a plane that is noise, or as deep as thick", thin_bodies},
    {"thin_bodies_in_motion", "as before, moved by steps of about the thickness, with the cache kept",
     "verdicts wrong from a warm start alone", thin_bodies_in_motion, true},
    {"cubes_random", "two cubes at random orientation", "the original: nothing in 10^6", cubes_random},
    {"cubes_near_parallel", "an angle of e^-20 to 1 rad", "the original: nothing in 10^6",
     cubes_near_parallel},
    {"cubes_half_lattice", "axis-aligned, offsets in halves", "the original: 9253 cycles in 10^6",
     cubes_half_lattice},
    {"cubes_identical_pose", "both in one pose", "the original: 62311 cycles in 10^6", cubes_identical_pose},
    {"cubes_45_degrees", "45 degrees about z, offsets in halves", "the original: 5782 cycles in 10^6",
     cubes_45_degrees},
    {"cubes_quarter_turns", "quarter turns, offsets in twentieths",
     "the original: 1248 cycles and 24 false disjoint in 10^6", cubes_quarter_turns},
};

}  // namespace

std::span<const HardFamily> hard_families() { return all; }

}  // namespace edgewise::scene
