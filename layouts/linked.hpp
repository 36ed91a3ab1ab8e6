// SPDX-License-Identifier: MIT
//
// Nodes and pointers, as a program of 1998 would have held a body: a node per vertex, edge and face, and at
// each vertex and each face a linked list of the planes that bound its Voronoi region, its cone. Vertex and
// face tests walk a cone and never touch an edge unless they go there; an edge reaches its own four planes
// through its cones' nodes, one hop farther than an array would need. Handles are pointers to nodes.
//
// Each node is allocated by itself, in the order in which a builder would: each vertex and its cone, then the
// edges, then each face and its cone. The allocator decides where they lie, and its headers and size classes
// come on top. A support table has only vertices and spokes. The bytes: planes are in the cones, once each;
// all pointers are topology, eight bytes each, and 18 of them per edge, in its node and its four cone nodes:
// 144 bytes in addition to 160 bytes of planes, direction and length in double, 80 in single.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/linked_table.hpp"
#include "edgewise/layout_parts/node_structs.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class linked : public LinkedTable<NodeStructs<typename P::Stored>, P, Loader> {
    using Base = LinkedTable<NodeStructs<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "linked";
    static constexpr std::string_view stores =
        "nodes and pointers, planes in linked lists by vertex and face";

    using Base::Base;
};

}  // namespace edgewise
