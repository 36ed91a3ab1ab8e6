// SPDX-License-Identifier: MIT
//
// The body that a table really holds: as given, rounded to single, or changed by a lossy layout, and perhaps
// in another order of vertices. A rounded body is the hull of its stored points.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/vertex_order.hpp"

namespace edgewise {

template <class Table>
inline constexpr bool is_lossy = requires(const Polyhedron& body) {
    Table::stored_body(body);
};

namespace detail {
template <class Table>
[[nodiscard]] Result<Polyhedron> rounded_body(const Polyhedron& body) {
    if constexpr (is_lossy<Table>) {
        return Table::stored_body(body);
    } else if constexpr (std::is_same_v<typename Table::PrecisionType::Stored, float>) {
        return round_to_single(body);
    } else {
        return Result<Polyhedron>::success(body);
    }
}

template <class Table>
[[nodiscard]] Result<Polyhedron> too_large(std::size_t most, const char* what, std::size_t count) {
    return Result<Polyhedron>::failure(std::string(Table::name) + " takes bodies of up to " +
                                       std::to_string(most) + " " + what + ", and this one has " +
                                       std::to_string(count));
}
}  // namespace detail

/// Returns the body as the table stores it. Fails when the storage cannot hold it: out of range, nothing left
/// of it, or too large for the layout's indices. A layout declares `static constexpr std::size_t
/// most_neighbours`, in the rings of all vertices together, or most_vertices. A layout with a vertex order of
/// its own declares `static constexpr VertexOrder vertex_order`.
template <class Table>
[[nodiscard]] Result<Polyhedron> stored_body(const Polyhedron& body) {
    auto stored = detail::rounded_body<Table>(body);
    if (!stored) return stored;
    if constexpr (requires { Table::most_neighbours; }) {
        if (stored->vertex_ring.size() > Table::most_neighbours)
            return detail::too_large<Table>(Table::most_neighbours / 2, "edges", stored->edge_count());
    }
    if constexpr (requires { Table::most_vertices; }) {
        if (stored->vertex_count() > Table::most_vertices)
            return detail::too_large<Table>(Table::most_vertices, "vertices", stored->vertex_count());
    }
    if constexpr (requires { Table::vertex_order; }) {
        auto ordered = reordered(*stored, Table::vertex_order);
        ordered.warning = std::move(stored.warning);
        return ordered;
    }
    return stored;
}

/// Name of the storage: "double", "single", or the lossy table type. Equal names mean equal stored bodies.
template <class Table>
[[nodiscard]] std::string storage_name() {
    using P = typename Table::PrecisionType;
    if constexpr (is_lossy<Table>) return std::string(Table::name) + "_" + std::string(P::name);
    return std::is_same_v<typename P::Stored, float> ? "single" : "double";
}

}  // namespace edgewise
