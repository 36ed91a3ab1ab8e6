// SPDX-License-Identifier: MIT
//
// Bullet's GJK of btGjkEpa2: distances of separated hulls, by linear scans. A cold query starts along the
// line of the centres, as Bullet's own depth solver does, a warm one along the last direction.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include "edgewise/peers/adapters/bullet.hpp"

namespace edgewise::peers {

namespace {

struct BulletEpa2 {
    static constexpr const char* name = "bullet_epa2";
    static constexpr const char* precision = bullet_precision;
    static constexpr const char* summary = "btGjkEpaSolver2::Distance on btConvexHullShape, margin 0";
    static constexpr const char* cache = "the last direction";

    using Shape = BulletShape;
    using Placed = BulletPlaced;
    struct Cache {
        btVector3 direction;
        bool is_warm = false;
    };

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                            Cache& cache, bool) {
        const btVector3 guess = cache.is_warm
                                    ? cache.direction
                                    : btVector3(at_b.transform.getOrigin() - at_a.transform.getOrigin());
        btGjkEpaSolver2::sResults found;
        const bool separated =
            btGjkEpaSolver2::Distance(&a.hull, at_a.transform, &b.hull, at_b.transform, guess, found);
        if (!separated || !(found.distance > 0)) return {};
        cache = {found.witnesses[0] - found.witnesses[1], true};
        return {.separated = true,
                .distance = found.distance,
                .point_a = from_bullet(found.witnesses[0]),
                .point_b = from_bullet(found.witnesses[1])};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<BulletEpa2>; }

}  // namespace edgewise::peers
