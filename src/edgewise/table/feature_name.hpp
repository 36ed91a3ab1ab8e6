// SPDX-License-Identifier: MIT
//
// Features of a table as small numbers, so that a pair of them fits into 8 bytes. Handles may be larger: an
// edge of a table that stores no edges is two vertices and a position in a ring.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "edgewise/table/contract.hpp"
#include "edgewise/table/feature_handle.hpp"

namespace edgewise {

/// Names are below 2^23. That covers all edges, faces and vertices of every body that polyhedron_builder.hpp
/// accepts.
inline constexpr int feature_name_bits = 23;

/// A table that numbers its features: `edge_named` and `face_named` turn a number back into a handle, and
/// return nothing for a number without an edge or face.
template <class T>
concept NamesFeatures = FeatureTable<T> && std::unsigned_integral<typename T::Vertex> &&
    requires(const T& table, typename T::Edge e, typename T::Face f, std::uint32_t name) {
    requires T::counts_vertices;
    { table.edge_name(e) } -> std::same_as<std::uint32_t>;
    { table.face_name(f) } -> std::same_as<std::uint32_t>;
    { table.edge_named(name) } -> std::same_as<std::optional<typename T::Edge>>;
    { table.face_named(name) } -> std::same_as<std::optional<typename T::Face>>;
};

template <NamesFeatures Table>
[[nodiscard]] std::uint32_t feature_name(const Table& table, const Feature<Table>& feature) {
    switch (feature.kind()) {
        case FeatureKind::vertex:
            return feature.vertex();
        case FeatureKind::edge:
            return table.edge_name(feature.edge());
        case FeatureKind::face:
            break;
    }
    return table.face_name(feature.face());
}

/// Returns the feature with this number, or the first vertex if no feature has it.
template <NamesFeatures Table>
[[nodiscard]] [[gnu::always_inline]] inline Feature<Table> feature_named(const Table& table, FeatureKind kind,
                                                                         std::uint32_t name) {
    using Named = Feature<Table>;
    if (kind == FeatureKind::edge) {
        if (const auto edge = table.edge_named(name)) return Named::of_edge(*edge);
    } else if (kind == FeatureKind::face) {
        if (const auto face = table.face_named(name)) return Named::of_face(*face);
    } else if (name < table.vertex_count()) {
        return Named::of_vertex(static_cast<typename Table::Vertex>(name));
    }
    return Named::of_vertex(table.first_vertex());
}

}  // namespace edgewise
