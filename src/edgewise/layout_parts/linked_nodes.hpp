// SPDX-License-Identifier: MIT
//
// The nodes of the layout `linked`, what their bytes are for, and lists of them as ranges.
#pragma once

#include <cassert>
#include <cstddef>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise {

template <class Stored>
struct LinkedNodes {
    struct Spoke;
    struct VertexCone;
    struct FaceCone;

    static constexpr std::size_t pointer = sizeof(void*);
    static constexpr Share plane_share{Component::voronoi_planes, sizeof(Plane<Stored>)};

    struct Vertex {
        Vec3<Stored> point;
        Index index;  // in the canonical body
        Spoke* spokes;
        Vertex* next;
        static Shares shares() {
            return {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                    {Component::topology, sizeof(Index)},
                    {Component::padding, (sizeof(Vec3<Stored>) + sizeof(Index)) % pointer},
                    {Component::topology, 2 * pointer}};
        }
    };
    struct Face {
        Plane<Stored> plane;
        FaceCone* cone;
        Face* next;
        static Shares shares() {
            return {{Component::face_planes, sizeof(Plane<Stored>)}, {Component::topology, 2 * pointer}};
        }
    };
    struct Edge {
        Vec3<Stored> direction;
        Stored length;
        Vertex* end[2];              // by End
        Face* side[2];               // by Side
        VertexCone* vertex_cone[2];  // by End
        FaceCone* face_cone[2];      // by Side
        static Shares shares() {
            return {{Component::edge_geometry, 4 * sizeof(Stored)}, {Component::topology, 8 * pointer}};
        }
    };
    /// One way out of a vertex: all that a support table knows of an edge.
    struct Spoke {
        Vertex* neighbour;
        Spoke* next;
        static Shares shares() { return {{Component::topology, 2 * pointer}}; }
    };
    struct VertexCone : Spoke {
        Plane<Stored> plane;
        Edge* edge;
        static Shares shares() {
            return {{Component::topology, 2 * pointer}, plane_share, {Component::topology, pointer}};
        }
    };
    struct FaceCone {
        Plane<Stored> plane;
        Edge* edge;
        FaceCone* next;
        static Shares shares() { return {plane_share, {Component::topology, 2 * pointer}}; }
    };
};

/// A list from one of its nodes on, each step a read through the loader; both range and iterator: `item` is
/// what a node stands for.
template <class Loader, class Node, class Item>
class LinkedList {
  public:
    LinkedList(const Loader& loader, const Node* at, Field field, Item item)
        : loader_(&loader), at_(at), field_(field), item_(item) {}
    [[nodiscard]] LinkedList begin() const { return *this; }
    [[nodiscard]] std::nullptr_t end() const { return nullptr; }
    auto operator*() const {
        assert(at_);
        return item_(at_);
    }
    LinkedList& operator++() {
        assert(at_);
        at_ = static_cast<const Node*>(loader_->load(at_->next, field_));
        return *this;
    }
    bool operator!=(std::nullptr_t) const { return at_ != nullptr; }

  private:
    const Loader* loader_;
    const Node* at_;
    Field field_;
    Item item_;
};

}  // namespace edgewise
