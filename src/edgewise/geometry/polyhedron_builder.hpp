// SPDX-License-Identifier: MIT
//
// From vertices and counter-clockwise face rings to the canonical Polyhedron (its order is documented in
// polyhedron.hpp). Whatever order the faces come in and wherever their rings start, the result has the same
// bits.
#pragma once

#include <span>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

/// Vertices and rings that may become a body; rings hold indices into `vertices`.
struct FaceRings {
    std::vector<Vec3d> vertices;
    std::vector<Index> input_index;  ///< names the vertices in messages, and in the result
    std::vector<std::vector<Index>> rings;
};

/// Takes rings of positions in `chosen`, which are indices of points. Returns only the vertices in use, in
/// the order of the input, with their input indices as names.
[[nodiscard]] FaceRings in_input_order(std::span<const Vec3d> points, std::span<const Index> chosen,
                                       std::span<const std::vector<Index>> rings);

/// Fails, with a reason, if the rings are not a closed surface of consistent winding: every edge between two
/// faces that run it in opposite directions, at least three faces around every vertex (of a polygon, two),
/// all in one fan. Says nothing about convexity. Faces without area get a zero normal.
[[nodiscard]] Result<Polyhedron> build_polyhedron(const FaceRings& input);

/// Builds the body as build_polyhedron does, with all rings reversed if the first face looks inward.
[[nodiscard]] Result<Polyhedron> build_outward(FaceRings input);

}  // namespace edgewise
