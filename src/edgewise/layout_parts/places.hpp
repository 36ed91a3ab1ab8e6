// SPDX-License-Identifier: MIT
//
// Places where a layout keeps a vector, a plane or an edge's ends: in one piece, or scalar by scalar. One
// pair of functions reads and writes each through either.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

/// The scalars of one element, each in a row of its own; rows start `step` scalars apart.
template <class Scalar>
struct Strided {
    Scalar* first = nullptr;
    std::size_t step = 0;

    [[nodiscard]] Scalar& operator[](std::size_t row) const { return first[row * step]; }
    /// Scalars from this row on, of the element at this place of the rows.
    [[nodiscard]] Strided from(std::size_t row, std::size_t at) const {
        return {first + row * step + at, step};
    }
};

template <class To, class Loader, class Stored>
[[nodiscard]] Vec3<To> read_vector(const Loader& loader, const Vec3<Stored>& at, Field field) {
    return cast<To>(loader.load(at, field));
}
template <class To, class Loader, class Stored>
[[nodiscard]] Vec3<To> read_vector(const Loader& loader, const Strided<Stored>& at, Field field) {
    const auto read = [&](std::size_t k) { return static_cast<To>(loader.load(at[k], field)); };
    return {read(0), read(1), read(2)};
}
template <class Stored>
void write_vector(Vec3<Stored>& to, const Vec3d& v) {
    to = cast<Stored>(v);
}
template <class Stored>
void write_vector(const Strided<Stored>& to, const Vec3d& v) {
    const Vec3<Stored> stored = cast<Stored>(v);
    to[0] = stored.x();
    to[1] = stored.y();
    to[2] = stored.z();
}

template <class To, class Loader, class Stored>
[[nodiscard]] Plane<To> read_plane(const Loader& loader, const Plane<Stored>& at, Field field) {
    return cast<To>(loader.load(at, field));
}
template <class To, class Loader, class Stored>
[[nodiscard]] Plane<To> read_plane(const Loader& loader, const Strided<Stored>& at, Field field) {
    return {read_vector<To>(loader, at, field), static_cast<To>(loader.load(at[3], field))};
}
template <class Stored>
void write_plane(Plane<Stored>& to, const Plane<double>& p) {
    to = cast<Stored>(p);
}
template <class Stored>
void write_plane(const Strided<Stored>& to, const Plane<double>& p) {
    write_vector(to, p.normal);
    to[3] = static_cast<Stored>(p.offset);
}

/// The four ends of an edge, in the order of their rows.
inline constexpr std::array ends_in_order = {&PolyhedronEdge::tail, &PolyhedronEdge::head,
                                             &PolyhedronEdge::left, &PolyhedronEdge::right};

[[nodiscard]] inline const Index& end_at(const PolyhedronEdge& ends, std::size_t k) {
    return ends.*ends_in_order[k];
}
[[nodiscard]] inline const Index& end_at(const Strided<Index>& ends, std::size_t k) { return ends[k]; }
inline void write_ends(PolyhedronEdge& to, const PolyhedronEdge& ends) { to = ends; }
inline void write_ends(const Strided<Index>& to, const PolyhedronEdge& ends) {
    for (std::size_t k = 0; k < ends_in_order.size(); ++k) to[k] = end_at(ends, k);
}

/// Writes all numbers of an edge that a table stores, to the places of its arrays or by their write_edge.
template <class Arrays>
void store_edge(const Arrays& to, Index e, const EdgeGeometry& g) {
    if constexpr (requires { to.write_edge(e, g); }) {
        to.write_edge(e, g);
    } else {
        write_plane(to.vertex_edge_plane(e, End::tail), g.tail_plane);
        write_plane(to.vertex_edge_plane(e, End::head), g.head_plane);
        write_plane(to.edge_face_plane(e, Side::left), g.left_plane);
        write_plane(to.edge_face_plane(e, Side::right), g.right_plane);
        write_vector(to.direction(e), g.direction);
        auto& length = to.length(e);
        length = static_cast<std::remove_reference_t<decltype(length)>>(g.length);
    }
}

}  // namespace edgewise
