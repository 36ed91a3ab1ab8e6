// SPDX-License-Identifier: MIT
//
// From V-Clip's pair of features to a simplex that GJK or EPA can start from.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/table/feature_handle.hpp"

namespace edgewise::vclip {

/// Writes up to four vertices of a feature, all of them if it has no more; returns their number.
template <FeatureTable Table>
[[nodiscard]] std::uint32_t corners_of(const Table& table, const Feature<Table>& feature,
                                       std::array<typename Table::Vertex, 4>& corners) {
    switch (feature.kind()) {
        case FeatureKind::vertex:
            corners[0] = feature.vertex();
            return 1;
        case FeatureKind::edge:
            corners[0] = table.tail(feature.edge());
            corners[1] = table.head(feature.edge());
            return 2;
        case FeatureKind::face:
            break;
    }
    std::uint32_t count = 0;
    for (const auto [edge, flipped] : table.ring_of_face(feature.face())) {
        if (count == corners.size()) break;
        corners[count++] = flipped ? table.head(edge) : table.tail(edge);
    }
    assert(count >= 3 && "a face has three corners or more");
    return count;
}

/// The corners of two features, up to the size of a simplex.
template <FeatureTable TableA, FeatureTable TableB>
[[nodiscard]] SimplexPair<TableA, TableB> feature_simplex(const TableA& a, const Feature<TableA>& feature_a,
                                                          const TableB& b, const Feature<TableB>& feature_b) {
    std::array<typename TableA::Vertex, 4> of_a;
    std::array<typename TableB::Vertex, 4> of_b;
    const std::uint32_t count_a = corners_of(a, feature_a, of_a), count_b = corners_of(b, feature_b, of_b);
    SimplexPair<TableA, TableB> simplex(a, b);
    for (std::uint32_t i = 0; i < std::max(count_a, count_b); ++i) {
        simplex.push({of_a[i % count_a], of_b[i % count_b]});
    }
    return simplex;
}

}  // namespace edgewise::vclip
