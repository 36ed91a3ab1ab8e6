// SPDX-License-Identifier: MIT
//
// Bullet's pair detector with its Voronoi simplex solver, and no solver for depths: what its collision world
// runs for separated hulls. It sets its cached axis back to (0, 1, 0) by itself: every query starts cold.
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "edgewise/peers/adapters/bullet.hpp"

namespace edgewise::peers {

namespace {

struct BulletPairDetector {
    static constexpr const char* name = "bullet_pair_detector";
    static constexpr const char* precision = bullet_precision;
    static constexpr const char* summary =
        "btGjkPairDetector and btVoronoiSimplexSolver on btConvexHullShape, margin 0";
    static constexpr const char* cache = "nothing";

    using Shape = BulletShape;
    using Placed = BulletPlaced;
    struct Cache {};

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b, Cache&,
                            bool) {
        btVoronoiSimplexSolver simplex;
        btGjkPairDetector detector(&a.hull, &b.hull, &simplex, nullptr);
        btGjkPairDetector::ClosestPointInput input;
        input.m_transformA = at_a.transform;
        input.m_transformB = at_b.transform;
        btPointCollector found;
        detector.getClosestPointsNonVirtual(input, found, nullptr);
        if (!found.m_hasResult || !(found.m_distance > 0)) return {};
        return {.separated = true,
                .distance = found.m_distance,
                .point_a = from_bullet(found.m_pointInWorld + found.m_normalOnBInWorld * found.m_distance),
                .point_b = from_bullet(found.m_pointInWorld)};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<BulletPairDetector>; }

}  // namespace edgewise::peers
