// SPDX-License-Identifier: MIT
//
// `proximity`: the test of continuous close proximity of "New Metrics for Evaluation of Collision Detection
// Techniques" (section 2): bodies close to each other, without linear velocity, turning very slowly, "of the
// order of 1/4 rad/s". It represents resting contacts, which gravity would bring about.
//
// Pairs of copies lie a small gap apart, each turned at random, and both bodies of a pair turn about their
// middles. The paper names no time step; with 60 steps per second 1/4 rad/s are 0.25 / 60 = 0.00417 rad per
// step. As they turn, gaps open and close and some pairs come to touch: about one in two of spheres does.
// Each step asks all pairs, in the same order.
#include <limits>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

constexpr double steps_a_second = 60;

/// Two bodies of a pair, the second placed a gap from the first along a random direction.
void add_pair(const SceneSetup& setup, const Vec3d& middle, Rng& rng, std::vector<MovingBody>& bodies) {
    const double size = extent(setup.shape.vertices), radius = reach(setup.shape.vertices, middle);
    const double gap = setup["gap"] * size;
    const auto body_at = [&](const Vec3d& place) {
        return MovingBody{place, Vec3d::Zero(), rng.orientation(),
                          rotation_about(rng.on_sphere(), setup["rotation_step"])};
    };
    const MovingBody a = body_at(rng.in_cube(size));
    MovingBody b = body_at(a.centre);
    const Vec3d direction = rng.on_sphere();
    const Pose pose_a = pose_of(a, middle);
    const auto place_b = [&](double s) { return Vec3d(a.centre + direction * s); };
    const auto distance_at = [&](double s) {
        return setup.distance(setup.shape, pose_a, setup.shape,
                              pose_at(rotation_matrix(b.orientation), middle, place_b(s)));
    };
    b.centre = place_b(coarse(find_offset(distance_at, gap, 2 * radius + gap, placement_tolerance * size)));
    bodies.push_back(a);
    bodies.push_back(b);
}

Result<Workload> make_proximity(const SceneSetup& setup) {
    Workload workload;
    workload.warm = true;
    workload.bodies.push_back(setup.shape);
    workload.pair_count = static_cast<std::uint32_t>(setup.count("pairs"));
    workload.instances.assign(2 * setup.count("pairs"), 0);
    const Vec3d middle = vertex_mean(setup.shape.vertices);
    Rng rng(setup.seed);
    std::vector<MovingBody> bodies;
    for (std::uint32_t pair = 0; pair < workload.pair_count; ++pair) add_pair(setup, middle, rng, bodies);
    while (workload.queries.size() < setup.query_count) {
        workload.frames.push_back({workload.queries.size(), false, {}});
        for (std::uint32_t pair = 0; pair < workload.pair_count; ++pair) {
            if (workload.queries.size() == setup.query_count) break;
            const MovingBody &a = bodies[2 * pair], &b = bodies[2 * pair + 1];
            workload.queries.push_back(
                {0, 0, pair, pose_of(a, middle), pose_of(b, middle), 2 * pair, 2 * pair + 1});
        }
        for (MovingBody& body : bodies) advance(body, std::numeric_limits<double>::infinity());
    }
    return Result<Workload>::success(std::move(workload));
}

}  // namespace

SceneKind proximity_scene() {
    return {{"proximity",
             "pairs a small gap apart, turning slowly in place: contacts that last",
             true,
             {{"pairs", "1", "pairs of bodies", 30, 1, 100000, true},
              {"gap", "body sizes", "between the bodies of a pair at the start", 0.001, 0, 10, false},
              {"rotation_step", "rad", "turn of every body per step: 1/4 rad/s at 60 steps per second",
               0.25 / steps_a_second, 0, 100, false}}},
            make_proximity,
            true};
}

}  // namespace edgewise::scene
