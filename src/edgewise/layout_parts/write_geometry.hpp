// SPDX-License-Identifier: MIT
//
// Writes a body's numbers into a table with its topology complete: when it is built, and again when the body
// has been deformed with the same topology. A layout writes one vertex, edge or face by
//
//     void write_vertex(Index v, const Vec3d& point);
//     void write_edge(Index e, const EdgeGeometry& edge);           // what it stores of an edge, if anything
//     void write_face(Index f, const Plane<double>& plane);         // likewise
//
// with the canonical body's indices. A layout with numbers that depend on the whole body writes them all at
// once: `void write_body(const Polyhedron&)`.
#pragma once

#include <cassert>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/body_facts.hpp"

namespace edgewise {

/// Edges are written when a table is built (`now`), or each when a query first asks for it (`when_asked`,
/// lazy.hpp).
enum class WriteEdges : bool { when_asked, now };

template <class Table>
concept WritesEdges = requires(Table& table, const EdgeGeometry& edge) {
    table.write_edge(Index{}, edge);
};
template <class Table>
concept WritesFaces = requires(Table& table, const Plane<double>& plane) {
    table.write_face(Index{}, plane);
};
template <class Table>
concept WritesBody = requires(Table& table, const Polyhedron& body) {
    table.write_body(body);
};

/// True if a table of this layout can take another body's numbers in place.
template <class Table>
concept Refittable = requires(Table& table, const Polyhedron& body) {
    table.note_facts(body);
    requires WritesBody<Table> || requires { table.write_vertex(Index{}, Vec3d{}); };
};

/// Writes all of the body's numbers that the table stores, for the edges and faces in the table's facts.
template <class Table>
void write_geometry(Table& table, const Polyhedron& body, WriteEdges edges = WriteEdges::now) {
    if constexpr (WritesBody<Table>) {
        table.write_body(body);
    } else {
        const BodyFacts& facts = table.facts();
        assert(body.vertex_count() == facts.vertex_count);
        for (Index v = 0; v < facts.vertex_count; ++v) table.write_vertex(v, body.vertices[v]);
        if constexpr (WritesFaces<Table>) {
            for (Index f = 0; f < facts.face_count; ++f) table.write_face(f, body.face_planes[f]);
        }
        if constexpr (WritesEdges<Table>) {
            if (edges == WriteEdges::when_asked) return;
            for (Index e = 0; e < facts.edge_count(); ++e) table.write_edge(e, edge_geometry(body, e));
        }
    }
}

/// Gives a table the numbers of a body of the same topology, in place: its answers are then those of a new
/// table of that body, bit by bit. Copies of a table and views through other loaders share its memory and not
/// its facts: make them again afterwards.
template <Refittable Table>
void refit(Table& table, const Polyhedron& body) {
    table.note_facts(body);
    write_geometry(table, body);
}

}  // namespace edgewise
