// SPDX-License-Identifier: MIT
//
// From a query's bare answer to everything that a user may ask for: features by names that survive outside
// (kind and input vertex indices) and, in contact, how deep the bodies overlap.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/algorithms/penetration/start.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/bench/certificates.hpp"
#include "edgewise/bench/named_answer.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::bench {

template <class Table>
[[nodiscard]] NamedFeature name_feature(const Table& table, const Polyhedron& body,
                                        const Feature<Table>& feature) {
    NamedFeature result;
    result.kind = feature.kind();
    const auto name = [&](auto v) { result.vertices.push_back(body.input_index[table.index_of(v)]); };
    switch (feature.kind()) {
        case FeatureKind::vertex:
            name(feature.vertex());
            break;
        case FeatureKind::edge:
            name(table.tail(feature.edge()));
            name(table.head(feature.edge()));
            break;
        case FeatureKind::face:
            for (const auto [edge, flipped] : table.ring_of_face(feature.face())) {
                name(flipped ? table.head(edge) : table.tail(edge));
            }
            break;
    }
    return result;
}

/// The vertices a simplex rests on: one is a vertex, two an edge, more a face. (They may span a diagonal.)
template <class Table>
[[nodiscard]] NamedFeature name_simplex(const Table& table, const Polyhedron& body,
                                        std::span<const typename Table::Vertex> vertices) {
    NamedFeature result;
    for (const auto v : vertices) result.vertices.push_back(body.input_index[table.index_of(v)]);
    std::sort(result.vertices.begin(), result.vertices.end());
    result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end()), result.vertices.end());
    result.kind = static_cast<FeatureKind>(std::min<std::size_t>(result.vertices.size(), 3) - 1);
    return result;
}

template <class TableA, class TableB>
[[nodiscard]] std::pair<NamedFeature, NamedFeature> name_features(const FeaturePair<TableA, TableB>& pair,
                                                                  const TableA& a, const Polyhedron& body_a,
                                                                  const TableB& b, const Polyhedron& body_b) {
    const Features<TableA, TableB> last = pair.start(a, b);
    return {name_feature(a, body_a, last.a), name_feature(b, body_b, last.b)};
}

template <class TableA, class TableB>
[[nodiscard]] std::pair<NamedFeature, NamedFeature> name_features(const SimplexPair<TableA, TableB>& pair,
                                                                  const TableA& a, const Polyhedron& body_a,
                                                                  const TableB& b, const Polyhedron& body_b) {
    const auto of_a = pair.vertices_a();
    const auto of_b = pair.vertices_b();
    return {name_simplex<TableA>(a, body_a, std::span(of_a).first(pair.count())),
            name_simplex<TableB>(b, body_b, std::span(of_b).first(pair.count()))};
}

/// The pair that a query was about.
template <class Table>
struct AskedPair {
    const Table &a, &b;
    const Polyhedron &body_a, &body_b;  ///< as stored
    const scene::Query& query;
};

/// Adds the depth, which shows if the contact is more than a touch, to the rounding of coordinates.
template <class Table, class Pair>
void measure_contact(const AskedPair<Table>& asked, const Pair& pair, const Distance& distance,
                     NamedAnswer& answer) {
    const auto& [a, b, body_a, body_b, query] = asked;
    const auto a_from_b = relative_pose(query.pose_a, query.pose_b);
    PenetrationSpace space;
    const Penetration overlap = penetration(a, b, a_from_b, simplex_of(a, b, pair), space);
    const double size =
        std::max({max_abs(overlap.point_a), max_abs(overlap.point_b), max_abs(a_from_b.translation)});
    const double noise = static_cast<double>(Tolerance<ComputeOf<Table>>::contact_noise) * size;
    auto simplex = simplex_of(a, b, pair);
    Distance unread;
    run_gjk(a, b, cast<ComputeOf<Table>>(a_from_b), simplex, QueryOptions{}, unread);
    for (std::uint32_t i = 0; i < simplex.count(); ++i) {
        answer.proof_a.push_back(a.index_of(simplex.corner(i).a));
        answer.proof_b.push_back(b.index_of(simplex.corner(i).b));
    }
    Distance contact = distance;
    contact.status = overlap.depth > noise ? Status::overlapping : Status::touching;
    contact.normal = overlap.normal;
    contact.point_a = overlap.point_a;
    contact.point_b = overlap.point_b;
    answer.distance = to_world(contact, query.pose_a);
    answer.depth = overlap.depth;
    answer.depth_cut_short = !overlap.converged;
    answer.normal = query.pose_a.rotation * overlap.normal;
}

/// `pair` as the query left it: a failed query left nothing in it, and its answer has no more than that
/// status. Depth and proofs only where `needs` asks for them and the bodies are in contact.
template <class Table, class Pair>
void name_answer(const AskedPair<Table>& asked, const Pair& pair, const Distance& distance, Needs needs,
                 NamedAnswer& answer) {
    answer.distance = distance;
    if (distance.status == Status::failed) return;
    answer.distance = to_world(distance, asked.query.pose_a);
    const bool separated = distance.status == Status::separated || distance.distance > 0;
    if (!separated && needs >= Needs::depth) measure_contact(asked, pair, distance, answer);
    std::tie(answer.feature_a, answer.feature_b) =
        name_features(pair, asked.a, asked.body_a, asked.b, asked.body_b);
}

/// Width of the certificate for bodies as stored; 0 where there is no certificate.
[[nodiscard]] inline double certified_width(const NamedAnswer& answer, const scene::Query& query,
                                            std::span<const Polyhedron> stored) {
    const auto certificates = certificates_of(answer, query, stored, stored);
    return certificates ? certificates->stored.width() : 0;
}

/// Computes the parts beyond distance and witnesses, and drops them. `stored`: all bodies, as stored.
template <class Table, class Pair>
[[gnu::noinline]] void pay_for_more(const AskedPair<Table>& asked, const Pair& pair, const Distance& distance,
                                    Needs needs, std::span<const Polyhedron> stored) {
    NamedAnswer more;
    name_answer(asked, pair, distance, needs, more);
    volatile double sink = more.depth;
    if (needs == Needs::certificate) sink = certified_width(more, asked.query, stored);
    static_cast<void>(sink);
}

}  // namespace edgewise::bench
