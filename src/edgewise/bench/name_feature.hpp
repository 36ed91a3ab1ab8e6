// SPDX-License-Identifier: MIT
//
// From an algorithm's own record of where it ended to names that survive outside: kind and input vertex
// indices.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/feature.hpp"

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
    return {name_feature(a, body_a, pair.a), name_feature(b, body_b, pair.b)};
}

template <class TableA, class TableB>
[[nodiscard]] std::pair<NamedFeature, NamedFeature> name_features(const SimplexPair<TableA, TableB>& pair,
                                                                  const TableA& a, const Polyhedron& body_a,
                                                                  const TableB& b, const Polyhedron& body_b) {
    return {name_simplex(a, body_a, std::span(pair.vertex_a).first(pair.count)),
            name_simplex(b, body_b, std::span(pair.vertex_b).first(pair.count))};
}

}  // namespace edgewise::bench
