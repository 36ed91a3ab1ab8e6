// SPDX-License-Identifier: MIT
//
// The nodes of the layout `linked`, field by field: the node of each field, the purpose of its bytes, and its
// place in a node that is a struct. Code that reads or writes nodes names a field and gets its place, so that
// a layout may keep the fields of a node elsewhere (grouped_nodes.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "edgewise/geometry/plane.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/table/field_map.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise {

/// A spoke is one edge as seen from a vertex, and all that a support table knows of it; a vertex cone is a
/// spoke with the plane of its edge there, a face cone the corresponding node in the list of a face.
template <class Stored>
struct LinkedNodes {
    struct Spoke;
    struct VertexCone;
    struct FaceCone;

    struct Vertex {
        Vec3<Stored> point;
        Index index;  // index in the canonical body
        Spoke* spokes;
        Vertex* next;
    };
    struct Face {
        Plane<Stored> plane;
        FaceCone* cone;
        Face* next;
    };
    struct Edge {
        Vec3<Stored> direction;
        Stored length;
        Vertex *tail, *head;
        Face *left, *right;
        VertexCone *tail_cone, *head_cone;
        FaceCone *left_cone, *right_cone;
    };
    struct Spoke {
        Vertex* neighbour;
        Spoke* next;
    };
    struct VertexCone : Spoke {
        Plane<Stored> plane;
        Edge* edge;
    };
    struct FaceCone {
        Plane<Stored> plane;
        Edge* edge;
        FaceCone* next;
    };
};

/// Fields in the order of the structs.
enum class NodeField : std::uint8_t {
    point,
    index,
    spokes,
    next_vertex,
    neighbour,
    next_spoke,
    vertex_plane,
    vertex_edge,
    direction,
    length,
    tail,
    head,
    left,
    right,
    tail_cone,
    head_cone,
    left_cone,
    right_cone,
    side_plane,
    side_edge,
    next_side,
    face_plane,
    cone,
    next_face,
};
inline constexpr std::size_t node_field_count = static_cast<std::size_t>(NodeField::next_face) + 1;

enum class NodeKind : std::uint8_t { vertex, vertex_cone, edge, face_cone, face };
inline constexpr std::size_t node_kind_count = static_cast<std::size_t>(NodeKind::face) + 1;
inline constexpr std::array<std::string_view, node_kind_count> node_kind_names = {
    "vertex", "vertex_cone", "edge", "face_cone", "face"};

struct NodeFieldInfo {
    std::string_view name;
    NodeKind kind;
    Component component;
};

inline constexpr std::array<NodeFieldInfo, node_field_count> node_field_infos = {{
    {"point", NodeKind::vertex, Component::vertex_coordinates},
    {"index", NodeKind::vertex, Component::topology},
    {"spokes", NodeKind::vertex, Component::topology},
    {"next_vertex", NodeKind::vertex, Component::topology},
    {"neighbour", NodeKind::vertex_cone, Component::topology},
    {"next_spoke", NodeKind::vertex_cone, Component::topology},
    {"vertex_plane", NodeKind::vertex_cone, Component::voronoi_planes},
    {"vertex_edge", NodeKind::vertex_cone, Component::topology},
    {"direction", NodeKind::edge, Component::edge_geometry},
    {"length", NodeKind::edge, Component::edge_geometry},
    {"tail", NodeKind::edge, Component::topology},
    {"head", NodeKind::edge, Component::topology},
    {"left", NodeKind::edge, Component::topology},
    {"right", NodeKind::edge, Component::topology},
    {"tail_cone", NodeKind::edge, Component::topology},
    {"head_cone", NodeKind::edge, Component::topology},
    {"left_cone", NodeKind::edge, Component::topology},
    {"right_cone", NodeKind::edge, Component::topology},
    {"side_plane", NodeKind::face_cone, Component::voronoi_planes},
    {"side_edge", NodeKind::face_cone, Component::topology},
    {"next_side", NodeKind::face_cone, Component::topology},
    {"face_plane", NodeKind::face, Component::face_planes},
    {"cone", NodeKind::face, Component::topology},
    {"next_face", NodeKind::face, Component::topology},
}};

[[nodiscard]] constexpr const NodeFieldInfo& info_of(NodeField field) {
    return node_field_infos[static_cast<std::size_t>(field)];
}

/// Members of the structs, in the order of NodeField.
template <class Stored, class N = LinkedNodes<Stored>>
inline constexpr auto node_members =
    std::tuple{&N::Vertex::point,    &N::Vertex::index,    &N::Vertex::spokes,    &N::Vertex::next,
               &N::Spoke::neighbour, &N::Spoke::next,      &N::VertexCone::plane, &N::VertexCone::edge,
               &N::Edge::direction,  &N::Edge::length,     &N::Edge::tail,        &N::Edge::head,
               &N::Edge::left,       &N::Edge::right,      &N::Edge::tail_cone,   &N::Edge::head_cone,
               &N::Edge::left_cone,  &N::Edge::right_cone, &N::FaceCone::plane,   &N::FaceCone::edge,
               &N::FaceCone::next,   &N::Face::plane,      &N::Face::cone,        &N::Face::next};

template <class Stored, NodeField field>
inline constexpr auto node_member = std::get<static_cast<std::size_t>(field)>(node_members<Stored>);

namespace detail {
template <class Node, class Value>
Value value_of(Value Node::*);
}  // namespace detail

/// Type of the value that a field holds.
template <class Stored, NodeField field>
using NodeValue = decltype(detail::value_of(node_member<Stored, field>));

/// Calls use(constant of the field) for each field in order.
template <class Use>
constexpr void for_each_node_field(Use use) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        (use(std::integral_constant<NodeField, static_cast<NodeField>(i)>()), ...);
    }
    (std::make_index_sequence<node_field_count>());
}

/// Descriptions of the fields, by number.
template <class Stored>
[[nodiscard]] std::array<RecordField, node_field_count> sized_node_fields() {
    std::array<RecordField, node_field_count> sized;
    for_each_node_field([&](auto field) {
        using Value = NodeValue<Stored, field()>;
        const NodeFieldInfo& info = info_of(field());
        // A pointer field holds the pointer itself. NOLINTNEXTLINE(bugprone-sizeof-expression)
        constexpr std::uint32_t bytes = sizeof(Value);
        sized[static_cast<std::size_t>(field())] = {
            info.name, node_kind_names[static_cast<std::size_t>(info.kind)], bytes, alignof(Value)};
    });
    return sized;
}

template <class Stored, class Node>
[[nodiscard]] constexpr NodeKind kind_of() {
    using N = LinkedNodes<Stored>;
    if constexpr (std::is_same_v<Node, typename N::Vertex>) return NodeKind::vertex;
    if constexpr (std::is_same_v<Node, typename N::Edge>) return NodeKind::edge;
    if constexpr (std::is_same_v<Node, typename N::FaceCone>) return NodeKind::face_cone;
    if constexpr (std::is_same_v<Node, typename N::Face>) return NodeKind::face;
    return NodeKind::vertex_cone;
}

}  // namespace edgewise
