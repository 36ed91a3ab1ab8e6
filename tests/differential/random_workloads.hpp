// SPDX-License-Identifier: MIT
//
// Workloads of random pairs, in every relation and at every gap of PairMaker, of solids and of flat bodies.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "bodies.hpp"
#include "edgewise/scene/workload.hpp"
#include "random_pairs.hpp"

namespace edgewise {

[[nodiscard]] inline std::vector<Polyhedron> bodies_of_random_pairs() {
    std::vector<Polyhedron> all;
    for (const NamedBody& named : flat_bodies()) all.push_back(named.body);
    for (const char* name : {"tetra4", "cube8", "sphere38", "sphere386"}) all.push_back(shape(name));
    return all;
}

/// Each body next to itself and next to the cube: `count` queries of one pair, cold and then warm.
[[nodiscard]] inline std::vector<scene::Workload> random_workloads(std::uint32_t count) {
    const std::vector<Polyhedron> bodies = bodies_of_random_pairs();
    constexpr std::uint32_t cube = 5;
    std::vector<scene::Workload> all;
    for (std::uint32_t a = 0; a < bodies.size(); ++a) {
        for (const std::uint32_t b : std::set<std::uint32_t>{a, cube}) {
            PairMaker maker(bodies[a], bodies[b], 100 + a);
            scene::Workload pairs;
            pairs.bodies = {bodies[a]};
            if (a != b) pairs.bodies.push_back(bodies[b]);
            pairs.pair_count = 1;
            for (std::uint32_t i = 0; i < count; ++i) {
                const RandomPair pair = maker.next();
                pairs.queries.push_back({0, a == b ? 0U : 1U, 0, pair.pose_a, pair.pose_b});
            }
            all.push_back(pairs);
            pairs.warm = true;
            all.push_back(pairs);
        }
    }
    return all;
}

}  // namespace edgewise
