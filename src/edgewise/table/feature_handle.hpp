// SPDX-License-Identifier: MIT
//
// A feature of a table: a kind and the layout's own handle for it. V-Clip keeps two features of a pair
// from one query to the next, each marked with its table, where features have no numbers
// (feature_name.hpp).
#pragma once

#include <cassert>
#include <cstdint>
#include <type_traits>

#include "edgewise/geometry/feature.hpp"
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

}  // namespace edgewise
