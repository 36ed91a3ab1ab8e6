// SPDX-License-Identifier: MIT
//
// Parts that the scenes share: the checked request, a body's middle and reach, its box in the
// world, and the box of a given occupancy. One function per scene; scenes.cpp lists them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "edgewise/algorithms/sweep_and_prune.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::scene {

/// A request with complete parameters, all within bounds.
struct SceneSetup {
    const Polyhedron& shape;
    const SceneParameters& parameters;
    std::uint64_t seed;
    std::size_t query_count;
    const DistanceFunction& distance;

    [[nodiscard]] double operator[](const char* name) const { return parameters.at(name); }
    [[nodiscard]] std::size_t count(const char* name) const {
        return static_cast<std::size_t>(parameters.at(name));
    }
};

/// Mean of the vertices: inside the body, whatever its shape.
[[nodiscard]] Vec3d vertex_mean(std::span<const Vec3d> vertices);

/// Largest distance of a vertex from a point.
[[nodiscard]] double reach(std::span<const Vec3d> vertices, const Vec3d& from);

/// Box of a posed body in world axes, by a full scan of the vertices.
[[nodiscard]] Aabb world_box(const Polyhedron& body, const Pose& pose);

/// Starts a step of the workload with its instances where the bodies are now. `margin`: by which boxes are
/// larger than bodies, on all sides.
Frame& add_step(std::span<const MovingBody> bodies, double margin, Workload& workload);

/// Slots of the pair cache: one for each uninterrupted stay of a pair in the list of pairs.
using PairSlots = std::map<BodyPair, std::uint32_t>;

/// Asks the pairs of a step, with the poses of the instances. A pair that was in `slots`, those of the step
/// before, starts warm. `slots` becomes those of this step.
void ask_pairs(std::span<const BodyPair> pairs, std::span<const Pose> poses, PairSlots& slots,
               Workload& workload);

/// Removes the queries beyond this count, with their steps and slots. Slots must be numbered in order of
/// appearance.
void cut(std::size_t query_count, Workload& workload);

/// The number cut to 24 leading bits. Lengths that come from sums over a body (its volume) or from a distance
/// algorithm go through this, so that their last bits cannot move a pose.
[[nodiscard]] double coarse(double x);

/// Cube root of a positive number, by Newton's method in IEEE + - * / only, because libm differs by machine.
[[nodiscard]] double cube_root(double x);

/// Half the side of the cube in which bodies of this total volume have this occupancy.
[[nodiscard]] double box_half(double total_volume, double occupancy);

/// Returns the place s on a ray through both centres where a body is at a wanted distance from another:
/// distance_at(s) is `target`, to a tolerance. `far`: a place where the bodies surely are farther from
/// each other than that.
///
/// Along the ray the distance f(s) of convex bodies is convex, its slope at most 1. So s - (f - target) never
/// passes the root, and neither does a secant through two points beyond it: the search comes down from far
/// off, needs no bracket, and takes about five evaluations.
template <class DistanceAt>
[[nodiscard]] double find_offset(const DistanceAt& distance_at, double target, double far, double tolerance) {
    constexpr int most_evaluations = 40;
    double s = far;
    double excess = distance_at(s) - target;
    double slope = 1;
    for (int i = 1; i < most_evaluations && excess > tolerance; ++i) {
        const double next = s - excess / slope;
        const double next_excess = distance_at(next) - target;
        if (next_excess < -tolerance) break;  // a step too far, by rounding or by a wrong distance: keep s
        slope = (excess - next_excess) / (s - next);
        s = next;
        excess = next_excess;
        if (!(slope > 0)) break;  // the distance does not fall any more: only rounding is left
    }
    return s;
}

/// Each kind of scene (kinds.json) has one.
using MakeScene = Result<Workload>(const SceneSetup&);
MakeScene make_static, make_cold, make_gap, make_tumble, make_proximity, make_pressure, make_resting,
    make_recorded;

}  // namespace edgewise::scene
