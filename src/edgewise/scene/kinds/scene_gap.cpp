// SPDX-License-Identifier: MIT
//
// `gap`: independent pairs at requested signed gaps, from deep to far. Both bodies are turned uniformly at
// random; B approaches A along a random line through both centres and stops where the gap is the wanted
// one. A gap is a fraction of the body's size: the distance of the bodies, or, below 0, how far B has moved
// along that line since it was about to touch. (The shortest way out may be another and is no longer.)
//
// Gaps are spread evenly over [gap, gap + span]. The range is cut into one equal part per query; the parts
// come in random order. With span 0 all gaps are equal, so a scene file that varies `gap` plots time over it.
//
// Each pair is measured where it was placed, and a scene that missed its gap is refused: thin bodies come out
// at the other side when they are pushed in too far.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

/// In body sizes, one for each query.
std::vector<double> spread_gaps(const SceneSetup& setup, Rng& rng) {
    std::vector<double> gaps;
    for (std::size_t i = 0; i < setup.query_count; ++i) {
        const double place =
            (static_cast<double>(i) + rng.uniform()) / static_cast<double>(setup.query_count);
        gaps.push_back(setup["gap"] + setup["span"] * place);
    }
    rng.shuffle(gaps);
    return gaps;
}

struct GapMaker {
    const SceneSetup& setup;
    Rng& rng;
    Vec3d centre;  ///< of the shape, in its frame
    double size, radius;

    /// Adds a pair at this gap (in body sizes). False: it was measured to be elsewhere.
    [[nodiscard]] bool add(double gap, Workload& workload) {
        const Mat3d rotation_a = rng.rotation();
        const Mat3d rotation_b = rng.rotation();
        const Vec3d place_a = rng.in_cube(size);
        const Vec3d direction = rng.on_sphere();
        const Pose pose_a = pose_at(rotation_a, centre, place_a);
        const auto place_b = [&](double s) { return pose_at(rotation_b, centre, place_a + direction * s); };
        const auto distance_at = [&](double s) {
            return setup.distance(setup.shape, pose_a, setup.shape, place_b(s));
        };
        // Touching is searched from outside, a tolerance away, because inside all distances are 0.
        const double tolerance = gap_placement_tolerance * size;
        const double target = std::max(gap * size, tolerance);
        const double outside = find_offset(distance_at, target, 2 * radius + target, tolerance / 2);
        const double offset = coarse(outside + std::min(gap, 0.0) * size);
        workload.queries.push_back({0, 0, workload.pair_count++, pose_a, place_b(offset), 0, 1});
        const double reached = distance_at(offset);
        return std::abs(distance_at(outside) - target) < tolerance &&
               (gap < 0 ? reached < tolerance : std::abs(reached - target) < tolerance);
    }
};

Result<Workload> make_gap(const SceneSetup& setup) {
    Workload workload;
    workload.bodies.push_back(setup.shape);
    workload.instances = {0, 0};
    const Vec3d centre = vertex_mean(setup.shape.vertices);
    Rng rng(setup.seed);
    const std::vector<double> gaps = spread_gaps(setup, rng);
    GapMaker maker{setup, rng, centre, extent(setup.shape.vertices), reach(setup.shape.vertices, centre)};
    for (const double gap : gaps) {
        if (maker.add(gap, workload)) continue;
        return Result<Workload>::failure(fmt::format(
            "scene 'gap': no pair could be placed at a gap of {:.3g} body sizes; a thin body comes "
            "out at the other side: raise gap",
            gap));
    }
    return Result<Workload>::success(std::move(workload));
}

}  // namespace

SceneKind gap_scene() {
    return {{"gap",
             "independent random pairs at signed gaps spread evenly from deep to far, every pair cold",
             false,
             {{"gap", "body sizes", "the smallest gap; below 0: how far B went on after it touched", -0.1,
               -0.5, 1, false},
              {"span", "body sizes", "from the smallest gap to the largest; 0: all have the same", 1.1, 0, 10,
               false}}},
            make_gap,
            true};
}

}  // namespace edgewise::scene
