// SPDX-License-Identifier: MIT
//
// What a scene hands to the runners: bodies, and the queries to ask in order. Algorithm and layout know
// nothing of scenes; a scene knows nothing of layouts.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "edgewise/algorithms/sweep_and_prune.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::scene {

struct Query {
    std::uint32_t body_a, body_b;  ///< indices into Workload::bodies
    std::uint32_t pair;            ///< pair-cache slot; queries of one slot follow each other in time
    Pose pose_a, pose_b;
    std::uint32_t instance_a = 0, instance_b = 0;  ///< indices into Workload::instances
};

/// One step of a scene that is asked step after step, all its pairs each.
struct Frame {
    std::size_t first_query = 0;   ///< its queries go on to the next frame's first
    bool starts_anew = false;      ///< other bodies than before: the broad phase knows nothing of them
    std::vector<Aabb> boxes;       ///< what the broad phase is given; empty: the scene has none
    std::vector<Pose> poses = {};  ///< poses of the instances, one for each box
    double margin = 0;             ///< by which a box is larger than its body, on all sides
};

struct Workload {
    std::vector<Polyhedron> bodies;
    std::vector<Query> queries;  ///< a pair's in time order
    std::vector<Frame> frames;   ///< of a scene in time order; empty: pair after pair, or one query each
    std::vector<std::uint32_t> instances;  ///< instances in the scene: the index of each one's body
    std::vector<double> radii;  ///< around the instances, in the bodies' unit; empty: the scene has none
    std::uint32_t pair_count = 0;
    bool warm = false;        ///< keep a pair's cache from query to query; else every query starts cold
    bool table_each = false;  ///< the scene is about a table for each instance; else instances share
};

/// Distance of two posed bodies (0 when they overlap); how a scene places pairs at a wanted distance.
using DistanceFunction =
    std::function<double(const Polyhedron&, const Pose&, const Polyhedron&, const Pose&)>;

/// Named numeric parameters of a scene, e.g. {"rotation_step", 0.01}; part of the cell's identity.
using SceneParameters = std::map<std::string, double>;

}  // namespace edgewise::scene
