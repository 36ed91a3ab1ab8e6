// SPDX-License-Identifier: MIT
//
// `pressure` and `proximity`: bodies that stay in place and turn about their middles; each step asks all
// pairs.
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
//
// `proximity`: the test of continuous close proximity of "New Metrics for Evaluation of Collision Detection
// Techniques" (section 2): bodies close to each other, without linear velocity, turning very slowly, "of the
// order of 1/4 rad/s". It represents resting contacts, which gravity would bring about.
//
// Pairs of copies lie a small gap apart, each turned at random, and both bodies of a pair turn about their
// middles. The paper names no time step; with 60 steps per second 1/4 rad/s are 0.25 / 60 = 0.00417 rad per
// step. As they turn, gaps open and close and some pairs come to touch: about one in two of spheres does.
// Each step asks all pairs, in the same order.
#include <algorithm>
#include <limits>
#include <numeric>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

/// Bodies that turn in place; pair k is the body `stride` * k and the one after it.
struct TurningPairs {
    std::vector<MovingBody> bodies;
    std::uint32_t stride;
    std::vector<std::uint32_t> order;  ///< of the pairs in a step
    Rng* reshuffles = nullptr;         ///< another order in each step
};

/// Asks pairs step after step, and turns the bodies after each, until there are `wanted` queries.
Workload ask_steps(const SceneSetup& setup, TurningPairs pairs, std::size_t wanted) {
    Workload workload;
    workload.warm = true;
    workload.bodies.push_back(setup.shape);
    workload.instances.assign(pairs.bodies.size(), 0);
    workload.pair_count = static_cast<std::uint32_t>(pairs.order.size());
    const Vec3d middle = vertex_mean(setup.shape.vertices);
    while (workload.queries.size() < wanted) {
        workload.frames.push_back({workload.queries.size(), false, {}});
        std::vector<Pose> poses;
        for (const MovingBody& body : pairs.bodies) poses.push_back(pose_of(body, middle));
        for (const std::uint32_t pair : pairs.order) {
            if (workload.queries.size() == wanted) break;
            const std::uint32_t a = pairs.stride * pair, b = a + 1;
            workload.queries.push_back({0, 0, pair, poses[a], poses[b], a, b});
        }
        for (MovingBody& body : pairs.bodies) advance(body, std::numeric_limits<double>::infinity());
        if (pairs.reshuffles) pairs.reshuffles->shuffle(pairs.order);
    }
    return workload;
}

/// 0 .. count-1
std::vector<std::uint32_t> in_order(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    return order;
}

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

}  // namespace

Result<Workload> make_pressure(const SceneSetup& setup) {
    const Vec3d middle = vertex_mean(setup.shape.vertices);
    const double spacing = coarse((2 + setup["gap"]) * reach(setup.shape.vertices, middle));
    Rng rng(setup.seed);
    TurningPairs pairs{turning_bodies(setup, spacing, rng), 1, in_order(setup.count("bodies") - 1)};
    rng.shuffle(pairs.order);
    if (setup.count("new_order") == 1) pairs.reshuffles = &rng;
    const std::size_t wanted = std::max(setup.query_count, setup.count("least_steps") * pairs.order.size());
    Workload workload = ask_steps(setup, std::move(pairs), wanted);
    workload.table_each = setup.count("own_tables") == 1;
    return Result<Workload>::success(std::move(workload));
}

Result<Workload> make_proximity(const SceneSetup& setup) {
    const Vec3d middle = vertex_mean(setup.shape.vertices);
    Rng rng(setup.seed);
    TurningPairs pairs{{}, 2, in_order(setup.count("pairs"))};
    for (std::size_t k = 0; k < pairs.order.size(); ++k) add_pair(setup, middle, rng, pairs.bodies);
    return Result<Workload>::success(ask_steps(setup, std::move(pairs), setup.query_count));
}

}  // namespace edgewise::scene
