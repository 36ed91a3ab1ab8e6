// SPDX-License-Identifier: MIT
//
// A body's numbers into a table whose topology stands: when it is built, and again when the body has been
// deformed with its topology kept. A layout says where one vertex, edge or face goes, by
//
//     void write_vertex(Index v, const Vec3d& point);
//     void write_edge(Index e, const EdgeGeometry& edge);           // what it stores of an edge, if anything
//     void write_face(Index f, const Plane<double>& plane);         // likewise
//
// with the canonical body's indices. A layout whose numbers depend on the whole body writes them all at once:
// `void write_body(const Polyhedron&)`.
#pragma once

#include <cassert>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/body_facts.hpp"

namespace edgewise {

/// Whether edges are written when a table is built, or left to somebody who writes each when it is asked for
/// (lazy.hpp).
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

/// Whether a table of this layout can take another body's numbers in place.
template <class Table>
concept Refittable = requires(Table& table, const Polyhedron& body) {
    table.note_facts(body);
    requires WritesBody<Table> || requires { table.write_vertex(Index{}, Vec3d{}); };
};

/// Everything the table stores of the body's numbers. The table's facts say how many edges and faces it has.
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

/// The table of a body of the same topology with other numbers, in place: what a new table of that body would
/// answer, bit by bit. Copies of a table and views through other loaders share its memory and not its facts:
/// make them anew afterwards.
template <Refittable Table>
void refit(Table& table, const Polyhedron& body) {
    table.note_facts(body);
    write_geometry(table, body);
}

}  // namespace edgewise
