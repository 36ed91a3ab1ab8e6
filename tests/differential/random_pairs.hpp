// SPDX-License-Identifier: MIT
//
// Random pairs of two bodies in the regimes that matter: gaps from three body sizes down to a billionth of
// one, and overlaps of the same depths; random, nearly equal and equal orientations, and
// lattices.
//
// B is moved along the line between the closest points, which keeps the closest features of the start. If the
// bodies start far apart, these are nearly always vertices; so half of the pairs start close together, where
// edges and faces are closest.
#pragma once

#include <limits>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise {

enum class Relation { generic, nearly_parallel, identical, lattice };

inline constexpr const char* relation_names[] = {"generic", "nearly parallel", "identical", "lattice"};

struct RandomPair {
    Relation relation = Relation::generic;
    Pose pose_a, pose_b;
    double gap = std::numeric_limits<double>::infinity();  ///< as placed; negative in overlap;
                                                           ///< infinite if not placed by a gap
};

class PairMaker {
  public:
    /// Keeps references.
    PairMaker(const Polyhedron& a, const Polyhedron& b, std::uint64_t seed);

    /// Six of ten are generic, two nearly parallel, one identical, one on a lattice.
    [[nodiscard]] RandomPair next();

  private:
    void orient(RandomPair& pair);
    void place_on_lattice(RandomPair& pair);
    void place(RandomPair& pair);
    [[nodiscard]] double wanted_gap();
    [[nodiscard]] double near_offset(const RandomPair& pair, const Vec3d& direction) const;

    const Polyhedron& a_;
    const Polyhedron& b_;
    scene::Rng rng_;
    double size_;
    int count_ = 0;
};

}  // namespace edgewise
