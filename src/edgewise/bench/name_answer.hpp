// SPDX-License-Identifier: MIT
//
// From a query's bare answer to everything that a user may ask for: features by name and, in contact, how
// deep the bodies overlap.
#pragma once

#include <algorithm>
#include <tuple>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/algorithms/penetration/start.hpp"
#include "edgewise/bench/certificates.hpp"
#include "edgewise/bench/name_feature.hpp"
#include "edgewise/bench/named_answer.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::bench {

/// What a query was about.
template <class Table>
struct AskedPair {
    const Table &a, &b;
    const Polyhedron &body_a, &body_b;  ///< as stored
    const scene::Query& query;
};

/// How deep, and with that whether it is more than a touch, to the rounding of coordinates.
template <class Table, class Pair>
void measure_contact(const AskedPair<Table>& asked, const Pair& pair, const Distance& distance,
                     NamedAnswer& answer) {
    const auto& [a, b, body_a, body_b, query] = asked;
    const auto a_from_b = relative_pose(query.pose_a, query.pose_b);
    PenetrationSpace<Table, Table> space;
    const Penetration overlap = penetration(a, b, a_from_b, simplex_of(a, b, pair), space);
    const double size =
        std::max({max_abs(overlap.point_a), max_abs(overlap.point_b), max_abs(a_from_b.translation)});
    const double noise = static_cast<double>(Tolerance<ComputeOf<Table>>::contact_noise) * size;
    auto simplex = simplex_of(a, b, pair);
    static_cast<void>(GjkRun<Table, Table>(a, b, cast<ComputeOf<Table>>(a_from_b)).run(simplex));
    for (std::uint32_t i = 0; i < simplex.count; ++i) {
        answer.proof_a.push_back(a.index_of(simplex.vertex_a[i]));
        answer.proof_b.push_back(b.index_of(simplex.vertex_b[i]));
    }
    Distance settled = distance;
    settled.status = overlap.depth > noise ? Status::overlapping : Status::touching;
    settled.normal = overlap.normal;
    settled.point_a = overlap.point_a;
    settled.point_b = overlap.point_b;
    answer.distance = to_world(settled, query.pose_a);
    answer.depth = overlap.depth;
    answer.depth_cut_short = !overlap.converged;
    answer.normal = query.pose_a.rotation * overlap.normal;
}

/// `pair` as the query left it. Depth and proofs only where `needs` asks for them and the bodies are in
/// contact.
template <class Table, class Pair>
void name_answer(const AskedPair<Table>& asked, const Pair& pair, const Distance& distance, Needs needs,
                 NamedAnswer& answer) {
    answer.distance = to_world(distance, asked.query.pose_a);
    const bool apart = distance.status == Status::separated || distance.distance > 0;
    if (!apart && needs >= Needs::depth) measure_contact(asked, pair, distance, answer);
    std::tie(answer.feature_a, answer.feature_b) =
        name_features(pair, asked.a, asked.body_a, asked.b, asked.body_b);
}

/// Of the certificate for bodies as stored; 0 where none can be made.
[[nodiscard]] inline double certified_width(const NamedAnswer& answer, const scene::Query& query,
                                            std::span<const Polyhedron> stored) {
    const auto certificates = certificates_of(answer, query, stored, stored);
    return certificates ? certificates->stored.width() : 0;
}

}  // namespace edgewise::bench
