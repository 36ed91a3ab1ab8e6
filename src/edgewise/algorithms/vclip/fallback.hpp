// SPDX-License-Identifier: MIT
//
// Answers a run that came back to a pair it has seen, or ended at one that rounding may have chosen. First
// the corners of its features are tried, which are kept if they provably hold the closest points
// (kept_simplex.hpp). Else GJK answers, on the same tables, without Voronoi planes, from these corners; its
// simplex is turned back into features, so that the next query starts near.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <span>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/kept_simplex.hpp"
#include "edgewise/algorithms/vclip/body.hpp"
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

template <class Table>
[[nodiscard]] bool face_holds(const Table& table, typename Table::Face face, typename Table::Vertex v) {
    for (const auto [edge, flipped] : table.ring_of_face(face)) {
        if (table.tail(edge) == v || table.head(edge) == v) return true;
    }
    return false;
}

/// The smallest feature that holds all the vertices; their first vertex when no edge or face does.
template <class Table>
[[nodiscard]] Feature<Table> feature_spanning(const Table& table,
                                              std::span<const typename Table::Vertex> vertices) {
    assert(!vertices.empty() && vertices.size() <= 4);
    const auto first = vertices[0];
    const auto is_first = [&](auto v) { return v == first; };
    if (std::all_of(vertices.begin(), vertices.end(), is_first)) return Feature<Table>::of_vertex(first);
    for (const auto [edge, flipped] : table.ring_of_vertex(first)) {
        const auto other = flipped ? table.tail(edge) : table.head(edge);
        const auto is_end = [&](auto v) { return v == first || v == other; };
        if (std::all_of(vertices.begin(), vertices.end(), is_end)) return Feature<Table>::of_edge(edge);
    }
    for (const auto [edge, flipped] : table.ring_of_vertex(first)) {
        for (const auto face : {table.left(edge), table.right(edge)}) {
            if (face == Table::no_face) continue;
            const auto is_on = [&](auto v) { return face_holds(table, face, v); };
            if (std::all_of(vertices.begin(), vertices.end(), is_on)) return Feature<Table>::of_face(face);
        }
    }
    return Feature<Table>::of_vertex(first);
}

/// Looks for the triangle of a face's fan over which the other body's vertex lies; push(v) adds the pair of a
/// corner and that vertex.
template <class Kept, class Table, class Push>
[[nodiscard]] bool rests_on_face(Kept& kept, const Body<Table>& body, const Push& push) {
    typename Table::Vertex first{}, last{};
    int met = 0;
    for (const auto [edge, flipped] : body.table.ring_of_face(body.feature.face())) {
        const auto corner = flipped ? body.table.head(edge) : body.table.tail(edge);
        if (++met == 1) first = corner;
        if (met > 2) {
            kept.clear();
            push(first);
            push(last);
            push(corner);
            if (kept.rests_on_all()) return true;
        }
        last = corner;
    }
    return false;
}

/// Looks for the half of the parallelogram of two edges that holds the closest point.
template <class Kept, class TableA, class TableB>
[[nodiscard]] bool rests_on_edges(Kept& kept, const Body<TableA>& a, const Body<TableB>& b) {
    const auto tail_a = a.table.tail(a.feature.edge()), head_a = a.table.head(a.feature.edge());
    const auto tail_b = b.table.tail(b.feature.edge()), head_b = b.table.head(b.feature.edge());
    for (const bool first : {true, false}) {
        kept.clear();
        kept.push(tail_a, tail_b);
        kept.push(head_a, head_b);
        kept.push(first ? head_a : tail_a, first ? tail_b : head_b);
        if (kept.rests_on_all()) return true;
    }
    return false;
}

/// Returns true if the closest point rests on corners of both features, up to three pairs, which `kept` then
/// holds.
template <class Kept, class TableA, class TableB>
[[nodiscard]] bool rests_on_features(Kept& kept, const Body<TableA>& a, const Body<TableB>& b) {
    using enum FeatureKind;
    if (a.feature.kind() == face)
        return rests_on_face(kept, a, [&](auto v) { kept.push(v, b.feature.vertex()); });
    if (b.feature.kind() == face)
        return rests_on_face(kept, b, [&](auto v) { kept.push(a.feature.vertex(), v); });
    if (a.feature.kind() == edge && b.feature.kind() == edge) return rests_on_edges(kept, a, b);
    const auto corners = feature_simplex(a.table, a.feature, b.table, b.feature);
    for (std::uint32_t i = 0; i < corners.count(); ++i) kept.push(corners.corner(i).a, corners.corner(i).b);
    return kept.rests_on_all();
}

/// Answers by corners of both features, which then stay; false if that is not proven.
template <class TableA, class TableB>
[[nodiscard]] bool answer_by_corners(const Body<TableA>& a, const Body<TableB>& b, Distance& answer) {
    if (!may_be_closest(a.feature.kind(), b.feature.kind())) return false;
    return ask_kept_simplex(a.table, b.table, a.from_other, [&](auto& kept) {
        if (!rests_on_features(kept, a, b) || !kept.is_proven({})) return false;
        kept.write(answer);
        return true;
    });
}

/// The same with everything inlined: queries of close bodies take 0.94 of the time. Traced tables do without:
/// their time is not measured, and the compiler takes a tenth longer.
template <class TableA, class TableB>
[[nodiscard]] EDGEWISE_QUERY_LOOP bool answer_by_corners_inlined(const Body<TableA>& a, const Body<TableB>& b,
                                                                 Distance& answer) {
    return answer_by_corners(a, b, answer);
}

template <class TableA, class TableB>
[[nodiscard]] [[gnu::noinline]] Distance answer_by_gjk(Body<TableA>& a, Body<TableB>& b) {
    auto simplex = feature_simplex(a.table, a.feature, b.table, b.feature);
    Distance answer;
    if constexpr (is_traced<TableA>)
        run_observed_gjk(a.table, b.table, a.from_other, simplex, QueryOptions{}, NoObserver(), answer);
    else
        run_gjk(a.table, b.table, a.from_other, simplex, QueryOptions{}, answer);
    if (answer.status == Status::failed) return answer;
    const std::uint32_t count = simplex.count();
    if (count == 0) return answer;
    const auto of_a = simplex.vertices_a();
    const auto of_b = simplex.vertices_b();
    a.feature = feature_spanning(a.table, std::span(of_a).first(count));
    b.feature = feature_spanning(b.table, std::span(of_b).first(count));
    // Two faces are no state; a vertex of the simplex replaces one of them.
    if (a.feature.kind() == FeatureKind::face && b.feature.kind() == FeatureKind::face)
        b.move_to_vertex(of_b[0]);
    return answer;
}

}  // namespace edgewise::vclip
