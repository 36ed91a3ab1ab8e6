// SPDX-License-Identifier: MIT
//
// `cold`: independent random pairs. Both bodies turned uniformly at random, B moved away from A along a
// random direction until their distance is the wanted one: uniform in 0 to 1 body size. About one pair in ten
// overlaps instead: centres at 50 to 100 % of their distance at contact along that direction, uniformly.
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

struct PairMaker {
    const SceneSetup& setup;
    Rng rng;
    Vec3d centre;  ///< of the shape, in its frame
    double size, radius;

    Query make(std::uint32_t slot) {
        const Mat3d rotation_a = rng.rotation();
        const Mat3d rotation_b = rng.rotation();
        const Vec3d place_a = rng.in_cube(size);
        const Vec3d direction = rng.on_sphere();
        const bool overlapping = rng.uniform() < setup["overlapping"];
        const double target = rng.uniform() * setup["distance"] * size;
        const double depth = rng.uniform() * (1 - setup["deepest"]);
        Query query{0, 0, slot, pose_at(rotation_a, centre, place_a), {}};
        const auto place_b = [&](double s) { return pose_at(rotation_b, centre, place_a + direction * s); };
        const auto distance_at = [&](double s) {
            return setup.distance(setup.shape, query.pose_a, setup.shape, place_b(s));
        };
        const double goal = overlapping ? 0 : target;
        const double offset = find_offset(distance_at, goal, 2 * radius + goal, placement_tolerance * size);
        query.pose_b = place_b(coarse(overlapping ? offset * (1 - depth) : offset));
        return query;
    }
};

Result<Workload> make_cold(const SceneSetup& setup) {
    Workload workload;
    workload.bodies.push_back(setup.shape);
    workload.instances = {0, 0};
    const Vec3d centre = vertex_mean(setup.shape.vertices);
    PairMaker maker{setup, Rng(setup.seed), centre, extent(setup.shape.vertices),
                    reach(setup.shape.vertices, centre)};
    while (workload.queries.size() < setup.query_count) {
        workload.queries.push_back(maker.make(workload.pair_count++));
        workload.queries.back().instance_b = 1;
    }
    return Result<Workload>::success(std::move(workload));
}

}  // namespace

SceneKind cold_scene() {
    return {
        {"cold",
         "independent random pairs, distance uniform in 0 to 1 body size, some overlapping, every pair cold",
         false,
         {{"distance", "body sizes", "largest distance of a separated pair", 1, 0, 100, false},
          {"overlapping", "1", "share of overlapping pairs", 0.1, 0, 1, false},
          {"deepest", "1", "centre distance over that at contact, in the deepest overlap", 0.5, 0, 1,
           false}}},
        make_cold,
        true};
}

}  // namespace edgewise::scene
