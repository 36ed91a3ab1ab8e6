// SPDX-License-Identifier: MIT
//
// A feature of a table: a kind and the layout's own handle for it. V-Clip keeps two features of a pair
// from one query to the next: as small numbers, so that a pair of them fits into 8 bytes, or, where
// features have no numbers, as handles that are marked with their table. A handle may be larger than a
// number: an edge of a table that stores no edges is two vertices and a position in a ring.
#pragma once

#include <cassert>
#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "edgewise/geometry/feature.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/identity.hpp"

namespace edgewise {

template <class Table>
class Feature {
  public:
    using Vertex = typename Table::Vertex;
    using Edge = typename Table::Edge;
    using Face = typename Table::Face;
    static_assert(std::is_trivially_copyable_v<Vertex> && std::is_trivially_copyable_v<Edge> &&
                  std::is_trivially_copyable_v<Face>);

    [[nodiscard]] static Feature of_vertex(Vertex v) {
        return Feature(FeatureKind::vertex, Handle{.vertex = v});
    }
    [[nodiscard]] static Feature of_edge(Edge e) { return Feature(FeatureKind::edge, Handle{.edge = e}); }
    [[nodiscard]] static Feature of_face(Face f) { return Feature(FeatureKind::face, Handle{.face = f}); }

    [[nodiscard]] FeatureKind kind() const { return kind_; }
    [[nodiscard]] Vertex vertex() const {
        assert(kind_ == FeatureKind::vertex);
        return handle_.vertex;
    }
    [[nodiscard]] Edge edge() const {
        assert(kind_ == FeatureKind::edge);
        return handle_.edge;
    }
    [[nodiscard]] Face face() const {
        assert(kind_ == FeatureKind::face);
        return handle_.face;
    }

    /// Returns this feature, marked as one of this table.
    [[nodiscard]] Feature of(const Table& table) const {
        Feature marked = *this;
        marked.mark_ = mark_of(table);
        return marked;
    }
    /// Returns true if it was last marked as one of this table: false after a rebuild (table/identity.hpp).
    [[nodiscard]] bool is_of(const Table& table) const { return mark_ == mark_of(table); }

    /// Compares the features only; marks do not count.
    [[nodiscard]] bool operator==(const Feature& other) const {
        if (kind_ != other.kind_) return false;
        switch (kind_) {
            case FeatureKind::vertex:
                return handle_.vertex == other.handle_.vertex;
            case FeatureKind::edge:
                return handle_.edge == other.handle_.edge;
            case FeatureKind::face:
                return handle_.face == other.handle_.face;
        }
        return false;
    }

  private:
    union Handle {
        Vertex vertex;
        Edge edge;
        Face face;
    };

    Feature(FeatureKind kind, Handle handle) : handle_(handle), kind_(kind) {}

    [[nodiscard]] static std::uint16_t mark_of(const Table& table) {
        return static_cast<std::uint16_t>(identity_of(table));
    }

    Handle handle_;
    FeatureKind kind_;
    std::uint16_t mark_ = 0;  ///< next to the kind, where padding would be
};

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
