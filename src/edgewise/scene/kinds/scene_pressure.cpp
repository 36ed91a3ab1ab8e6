// SPDX-License-Identifier: MIT
//
// `pressure`: more tables than any cache holds, as in the paper, where every instance had its own and
// "hundreds of such primitives" consumed all memory. Bodies lie on a cubic lattice, each with a table of
// its own, and turn about their middles. Each step queries every pair of neighbours once, in an order that
// does not follow memory. Whether a pair's data is still in the caches when the pair is queried again depends
// on the size of its tables. Engines repeat the order in every step, which is the worst case of caches that
// evict the least recently used line: a cache slightly too small misses everything. With new_order each step
// has another order.
//
// Neighbours follow each other along the lattice back and forth, so that every pair is near; spheres around
// the bodies never meet, so that every pair is separated.
#include <algorithm>
#include <cmath>
#include <limits>

#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

/// Place i on the way through a cube of `side` places each way: back and forth in x and y.
Vec3d place_on_way(std::size_t i, std::size_t side) {
    const std::size_t z = i / (side * side);
    std::size_t y = i / side % side, x = i % side;
    if ((i / side) % 2 == 1) x = side - 1 - x;
    if (z % 2 == 1) y = side - 1 - y;
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

std::vector<MovingBody> turning_bodies(const SceneSetup& setup, double spacing, Rng& rng) {
    const std::size_t count = setup.count("bodies");
    std::size_t side = 1;
    while (side * side * side < count) ++side;
    std::vector<MovingBody> bodies;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d centre = place_on_way(i, side) * spacing;
        bodies.push_back({centre, Vec3d::Zero(), rng.orientation(),
                          rotation_about(rng.on_sphere(), setup["rotation_step"])});
    }
    return bodies;
}

/// 0 .. count-1, shuffled.
std::vector<std::uint32_t> any_order(std::uint32_t count, Rng& rng) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < count; ++i) order.push_back(i);
    rng.shuffle(order);
    return order;
}

Result<Workload> make_pressure(const SceneSetup& setup) {
    Workload workload;
    workload.warm = true;
    workload.table_each = setup.count("own_tables") == 1;
    workload.bodies.push_back(setup.shape);
    workload.instances.assign(setup.count("bodies"), 0);
    const Vec3d middle = vertex_mean(setup.shape.vertices);
    const double spacing = coarse((2 + setup["gap"]) * reach(setup.shape.vertices, middle));
    Rng rng(setup.seed);
    std::vector<MovingBody> bodies = turning_bodies(setup, spacing, rng);
    workload.pair_count = static_cast<std::uint32_t>(bodies.size() - 1);
    std::vector<std::uint32_t> order = any_order(workload.pair_count, rng);
    const std::size_t wanted =
        std::max(setup.query_count, setup.count("least_steps") * std::size_t{workload.pair_count});
    while (workload.queries.size() < wanted) {
        workload.frames.push_back({workload.queries.size(), false, {}});
        std::vector<Pose> poses;
        for (const MovingBody& body : bodies) poses.push_back(pose_of(body, middle));
        for (const std::uint32_t pair : order) {
            if (workload.queries.size() == wanted) break;
            workload.queries.push_back({0, 0, pair, poses[pair], poses[pair + 1], pair, pair + 1});
        }
        for (MovingBody& body : bodies) advance(body, std::numeric_limits<double>::infinity());
        if (setup.count("new_order") == 1) rng.shuffle(order);
    }
    return Result<Workload>::success(std::move(workload));
}

}  // namespace

SceneKind pressure_scene() {
    return {
        {"pressure",
         "many bodies, a table per body, every body against the next in turn: more tables than caches hold",
         true,
         {{"bodies", "1", "bodies, and tables", 600, 2, 100000, true},
          {"rotation_step", "rad", "turn of every body per step", 0.1, 0, 100, false},
          {"gap", "reaches", "between the spheres around neighbours", 0.1, 0.001, 100, false},
          {"new_order", "1", "1: pairs in another order each step; 0: always in the same", 0, 0, 1, true},
          {"least_steps", "1", "steps asked at least, with more queries than asked for if need be", 0, 0,
           100000, true},
          {"own_tables", "1", "1: a table per body, as in the paper; 0: all bodies share one", 1, 0, 1,
           true}}},
        make_pressure};
}

}  // namespace edgewise::scene
