// SPDX-License-Identifier: MIT
//
// The body that a table really holds: as given, rounded to single, or whatever a lossy layout makes of it. A
// rounded body is the hull of its stored points.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>

#include "edgewise/geometry/hull.hpp"

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
}  // namespace detail

/// Fails when the storage cannot hold the body: out of its range, nothing is left of it, or larger than the
/// layout's indices can count: such a layout says `static constexpr std::size_t most_neighbours`, of the
/// rings of all vertices together.
template <class Table>
[[nodiscard]] Result<Polyhedron> stored_body(const Polyhedron& body) {
    auto stored = detail::rounded_body<Table>(body);
    if constexpr (requires { Table::most_neighbours; }) {
        if (stored && stored->vertex_ring.size() > Table::most_neighbours)
            return Result<Polyhedron>::failure(std::string(Table::name) + " takes bodies of up to " +
                                               std::to_string(Table::most_neighbours / 2) +
                                               " edges, and this one has " +
                                               std::to_string(stored->edge_count()));
    }
    return stored;
}

/// Table types of the same storage hold the same bodies: "double", "single", or the lossy table type itself.
template <class Table>
[[nodiscard]] std::string storage_name() {
    using P = typename Table::PrecisionType;
    if constexpr (is_lossy<Table>) return std::string(Table::name) + "_" + std::string(P::name);
    return std::is_same_v<typename P::Stored, float> ? "single" : "double";
}

}  // namespace edgewise
