// SPDX-License-Identifier: MIT
//
// A table's neighbours of every vertex compared with those of the body that it was built from, in order.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::testing {

template <class Table>
void expect_rings(const Table& table, const Polyhedron& body) {
    for (Index v = 0; v < body.vertex_count(); ++v) {
        std::vector<Index> found, expected;
        for (const Index w : table.neighbours(v)) found.push_back(w);
        for (const HalfEdge h : body.ring_of_vertex(v)) expected.push_back(body.head(h));
        ASSERT_EQ(found, expected) << Table::name << " vertex " << v << " of " << body.vertex_count();
    }
}

}  // namespace edgewise::testing
