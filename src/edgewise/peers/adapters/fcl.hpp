// SPDX-License-Identifier: MIT
//
// Parts that the adapters of FCL's two solvers share: its convex shape, its pose, and the query, which is the
// same for both.
#pragma once

#include <fcl/geometry/shape/convex.h>

#include <memory>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

[[nodiscard]] inline fcl::Convexd to_fcl(const Polyhedron& body) {
    auto vertices =
        std::make_shared<const std::vector<fcl::Vector3d>>(body.vertices.begin(), body.vertices.end());
    auto faces = std::make_shared<std::vector<int>>();
    for (std::size_t f = 0; f < body.face_count(); ++f) {
        const auto ring = body.ring_of_face(static_cast<Index>(f));
        faces->push_back(static_cast<int>(ring.size()));
        for (const HalfEdge h : ring) faces->push_back(static_cast<int>(body.tail(h)));
    }
    return {vertices, static_cast<int>(body.face_count()), faces};
}

struct FclShape {
    explicit FclShape(const Polyhedron& body) : convex(to_fcl(body)) {}
    fcl::Convexd convex;
};

struct FclPlaced {
    explicit FclPlaced(const Pose& pose) : transform(fcl::Transform3d::Identity()) {
        transform.linear() = pose.rotation;
        transform.translation() = pose.translation;
    }
    fcl::Transform3d transform;
};

/// Answers are in world coordinates.
template <class Solver>
[[nodiscard]] PeerAnswer ask_fcl(const Solver& solver, const FclShape& a, const FclPlaced& at_a,
                                 const FclShape& b, const FclPlaced& at_b) {
    double distance = 0;
    fcl::Vector3d point_a, point_b;
    const bool separated = solver.shapeDistance(a.convex, at_a.transform, b.convex, at_b.transform, &distance,
                                                &point_a, &point_b);
    if (!separated || !(distance > 0)) return {};
    return {.separated = true, .distance = distance, .point_a = point_a, .point_b = point_b};
}

}  // namespace edgewise::peers
