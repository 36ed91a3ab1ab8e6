// SPDX-License-Identifier: MIT
//
// `cold` and `gap`: independent pairs, each asked once. Both bodies are turned uniformly at random, and B
// lies on a random ray from A's centre through its own.
//
// `cold`: B is moved away from A until their distance is the wanted one: uniform in 0 to 1 body size. About
// one pair in ten overlaps instead: centres at 50 to 100 % of their distance at contact along the ray,
// uniformly.
//
// `gap`: pairs at requested signed gaps, from deep to far. B stops where the gap is the wanted one. A gap is
// a fraction of the body's size: the distance of the bodies, or, below 0, how far B has moved along the ray
// since it was about to touch. (The shortest way out may be another and is no longer.) Gaps are spread evenly
// over [gap, gap + span]. The range is cut into one equal part per query; the parts come in random order.
// With span 0 all gaps are equal, so a scene file that varies `gap` plots time over it. Each pair is measured
// where it was placed, and a scene that missed its gap is refused: thin bodies come out at the other side
// when they are pushed in too far.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

/// A scene's request, its random numbers, and what placing needs to know of the shape.
struct Placing {
    const SceneSetup& setup;
    Rng rng{setup.seed};
    Vec3d centre = vertex_mean(setup.shape.vertices);
    double size = extent(setup.shape.vertices), radius = reach(setup.shape.vertices, centre);
};

/// Two copies of the shape, each turned at random; how far B is from A along the ray is still open.
class RandomPair {
  public:
    explicit RandomPair(Placing& by) : by_(by) {
        const Mat3d rotation_a = by.rng.rotation();
        rotation_b_ = by.rng.rotation();
        place_a_ = by.rng.in_cube(by.size);
        direction_ = by.rng.on_sphere();
        pose_a_ = pose_at(rotation_a, by.centre, place_a_);
    }

    /// Distance of the bodies when B's centre is s away from A's.
    [[nodiscard]] double distance_at(double s) const {
        return by_.setup.distance(by_.setup.shape, pose_a_, by_.setup.shape, pose_b(s));
    }
    /// The s at which that distance is `target`.
    [[nodiscard]] double offset_of(double target, double tolerance) const {
        return find_offset([this](double s) { return distance_at(s); }, target, 2 * by_.radius + target,
                           tolerance);
    }
    void add_to(Workload& workload, double s) const {
        workload.queries.push_back({0, 0, workload.pair_count++, pose_a_, pose_b(s), 0, 1});
    }

  private:
    [[nodiscard]] Pose pose_b(double s) const {
        return pose_at(rotation_b_, by_.centre, place_a_ + direction_ * s);
    }

    const Placing& by_;
    Vec3d place_a_, direction_;
    Mat3d rotation_b_;
    Pose pose_a_;
};

Workload two_instances_of(const Polyhedron& shape) {
    Workload workload;
    workload.bodies.push_back(shape);
    workload.instances = {0, 0};
    return workload;
}

/// Returns one gap for each query, in body sizes.
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

/// Adds a pair at this gap (in body sizes). False: it was measured to be elsewhere.
bool add_at_gap(Placing& placing, double gap, Workload& workload) {
    const RandomPair pair(placing);
    const double size = placing.size;
    // Touching is searched from outside, a tolerance away, because inside all distances are 0.
    const double tolerance = gap_placement_tolerance * size;
    const double target = std::max(gap * size, tolerance);
    const double outside = pair.offset_of(target, tolerance / 2);
    const double offset = coarse(outside + std::min(gap, 0.0) * size);
    pair.add_to(workload, offset);
    const double reached = pair.distance_at(offset);
    return std::abs(pair.distance_at(outside) - target) < tolerance &&
           (gap < 0 ? reached < tolerance : std::abs(reached - target) < tolerance);
}

}  // namespace

Result<Workload> make_cold(const SceneSetup& setup) {
    Workload workload = two_instances_of(setup.shape);
    Placing placing{setup};
    while (workload.queries.size() < setup.query_count) {
        const RandomPair pair(placing);
        const bool overlapping = placing.rng.uniform() < setup["overlapping"];
        const double target = placing.rng.uniform() * setup["distance"] * placing.size;
        const double depth = placing.rng.uniform() * (1 - setup["deepest"]);
        const double offset = pair.offset_of(overlapping ? 0 : target, placement_tolerance * placing.size);
        pair.add_to(workload, coarse(overlapping ? offset * (1 - depth) : offset));
    }
    return Result<Workload>::success(std::move(workload));
}

Result<Workload> make_gap(const SceneSetup& setup) {
    Workload workload = two_instances_of(setup.shape);
    Placing placing{setup};
    for (const double gap : spread_gaps(setup, placing.rng)) {
        if (add_at_gap(placing, gap, workload)) continue;
        return Result<Workload>::failure(fmt::format(
            "scene 'gap': no pair could be placed at a gap of {:.3g} body sizes; a thin body comes "
            "out at the other side: raise gap",
            gap));
    }
    return Result<Workload>::success(std::move(workload));
}

}  // namespace edgewise::scene
