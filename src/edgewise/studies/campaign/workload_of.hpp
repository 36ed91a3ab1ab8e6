// SPDX-License-Identifier: MIT
//
// Turns a block's pairs into queries of one pair, in time order, each from cold.
#pragma once

#include "edgewise/scene/workload.hpp"
#include "edgewise/studies/campaign/pair_source.hpp"

namespace edgewise::studies::campaign {

[[nodiscard]] inline scene::Workload workload_of(const Block& block) {
    scene::Workload workload;
    workload.bodies = {block.a, block.b};
    workload.instances = {0, 1};
    workload.pair_count = 1;
    workload.queries.reserve(block.poses.size());
    for (const auto& [pose_a, pose_b] : block.poses)
        workload.queries.push_back({0, 1, 0, pose_a, pose_b, 0, 1});
    return workload;
}

}  // namespace edgewise::studies::campaign
