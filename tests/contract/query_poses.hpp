// SPDX-License-Identifier: MIT
//
// Relative poses for tests that need many queries and no oracle: far, near and overlapping, and the
// algorithms a table serves.
#pragma once

#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise {

/// Poses of a body next to its copy, in any orientation, centres at most 2.5 extents from each other.
[[nodiscard]] inline std::vector<Transform<double>> query_poses(std::size_t count, const Polyhedron& body,
                                                                std::uint64_t seed) {
    scene::Rng rng(seed);
    const double size = extent(body.vertices);
    Vec3d middle = Vec3d::Zero();
    for (const Vec3d& v : body.vertices) middle += v / static_cast<double>(body.vertex_count());
    std::vector<Transform<double>> poses;
    while (poses.size() < count) {
        Transform<double> pose;
        pose.rotation = rng.rotation();
        // One draw a statement: compilers evaluate operands in either order.
        const double away = rng.uniform(0, 2.5) * size;
        const Vec3d place = middle + rng.on_sphere() * away;
        pose.translation = place - multiply(pose.rotation, middle);
        poses.push_back(pose);
    }
    return poses;
}

/// Calls use(algorithm) with every algorithm that can run on this table.
template <class Table, class Use>
void for_each_algorithm(Use use) {
    use(Gjk{});
    if constexpr (FeatureTable<Table>) use(VClip{});
}

}  // namespace edgewise
