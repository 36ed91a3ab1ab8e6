// SPDX-License-Identifier: MIT
//
// The fields of a table that stores its answers, by name: those of a vertex, an edge, a face, and of an entry
// in either kind of ring; and the place of each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/layout_parts/places.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/field_map.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise {

enum class StoredField : std::uint8_t {
    point,
    vertex_offset,  ///< where the vertex' rows start
    tail_plane,
    head_plane,
    left_plane,
    right_plane,
    direction,
    length,
    tail,
    head,
    left,
    right,
    face_plane,
    face_offset,
    neighbour,
    vertex_ring,
    face_ring,
};
inline constexpr std::size_t stored_field_count = static_cast<std::size_t>(StoredField::face_ring) + 1;

struct StoredFieldInfo {
    std::string_view name, record;
    std::uint8_t scalars, indices;  ///< contents: number of stored scalars, or of 32-bit indices
    Component component;

    template <class Stored>
    [[nodiscard]] constexpr RecordField sized() const {
        const std::uint32_t one = scalars > 0 ? sizeof(Stored) : sizeof(Index);
        return {name, record, one * (scalars + indices), one};
    }
};

inline constexpr std::array<StoredFieldInfo, stored_field_count> stored_field_infos = {{
    {"point", "vertex", 3, 0, Component::vertex_coordinates},
    {"vertex_offset", "vertex", 0, 1, Component::topology},
    {"tail_plane", "edge", 4, 0, Component::voronoi_planes},
    {"head_plane", "edge", 4, 0, Component::voronoi_planes},
    {"left_plane", "edge", 4, 0, Component::voronoi_planes},
    {"right_plane", "edge", 4, 0, Component::voronoi_planes},
    {"direction", "edge", 3, 0, Component::edge_geometry},
    {"length", "edge", 1, 0, Component::edge_geometry},
    {"tail", "edge", 0, 1, Component::topology},
    {"head", "edge", 0, 1, Component::topology},
    {"left", "edge", 0, 1, Component::topology},
    {"right", "edge", 0, 1, Component::topology},
    {"face_plane", "face", 4, 0, Component::face_planes},
    {"face_offset", "face", 0, 1, Component::topology},
    {"neighbour", "vertex_ring", 0, 1, Component::topology},
    {"vertex_ring", "vertex_ring", 0, 1, Component::topology},
    {"face_ring", "face_ring", 0, 1, Component::topology},
}};

[[nodiscard]] constexpr const StoredFieldInfo& info_of(StoredField field) {
    return stored_field_infos[static_cast<std::size_t>(field)];
}

/// Descriptions of the fields, by number.
template <class Stored>
[[nodiscard]] std::array<RecordField, stored_field_count> sized_stored_fields() {
    std::array<RecordField, stored_field_count> sized;
    for (std::size_t i = 0; i < sized.size(); ++i) sized[i] = stored_field_infos[i].template sized<Stored>();
    return sized;
}

/// Number of records of a table with this field; 0: the table has no such field.
[[nodiscard]] inline std::size_t record_count(StoredField field, const BodyFacts& n) {
    using enum StoredField;
    const bool features = n.parts == Parts::features;
    if (field == point) return n.vertex_count;
    if (field == vertex_offset) return std::size_t{n.vertex_count} + 1;
    if (field == neighbour) return n.neighbour_count;
    if (field == vertex_ring) return features ? n.neighbour_count : 0;
    if (field == face_plane) return n.face_count;
    if (field == face_offset) return features ? std::size_t{n.face_count} + 1 : 0;
    if (field == face_ring) return n.face_ring_count();
    return n.edge_count();
}

/// Notes the places of fields, as offsets from a base.
class FieldMapper {
  public:
    template <class Stored>
    static FieldMapper of(const std::byte* base) {
        FieldMapper mapper(base);
        const auto sized = sized_stored_fields<Stored>();
        mapper.map_.fields.assign(sized.begin(), sized.end());
        return mapper;
    }

    /// Notes a field that lies in one piece.
    template <class Value>
    void note(StoredField field, Index element, const Value& place) {
        add(field, element, &place, sizeof(Value), 0);
    }
    /// Notes a field scalar by scalar.
    template <class Scalar>
    void note(StoredField field, Index element, const Strided<Scalar>& places) {
        const std::uint32_t bytes = map_.fields[static_cast<std::size_t>(field)].bytes;
        for (std::uint32_t part = 0; part < bytes; part += sizeof(Scalar))
            add(field, element, &places[part / sizeof(Scalar)], sizeof(Scalar), part);
    }
    [[nodiscard]] FieldMap take() { return std::move(map_); }

  private:
    explicit FieldMapper(const std::byte* base) : base_(base) {}

    void add(StoredField field, Index element, const void* at, std::size_t bytes, std::uint32_t part) {
        map_.places.push_back({static_cast<std::uint64_t>(static_cast<const std::byte*>(at) - base_), element,
                               static_cast<std::uint8_t>(field), static_cast<std::uint8_t>(part),
                               static_cast<std::uint8_t>(bytes)});
    }

    const std::byte* base_;
    FieldMap map_;
};

/// Map of the fields of arrays and rings in the form that StoredTable needs.
template <class Stored, class Arrays, class RingPlaces>
[[nodiscard]] FieldMap map_of_fields(const Arrays& at, const RingPlaces& rings, const BodyFacts& n,
                                     const std::byte* base) {
    using enum StoredField;
    FieldMapper mapper = FieldMapper::of<Stored>(base);
    const auto note_each = [&](StoredField field, const auto& place_of) {
        for (Index i = 0; i < record_count(field, n); ++i) mapper.note(field, i, place_of(i));
    };
    note_each(point, [&](Index v) -> decltype(auto) { return at.vertex(v); });
    note_each(vertex_offset, [&](Index v) -> decltype(auto) { return rings.vertex_offset_at(v); });
    note_each(tail_plane, [&](Index e) -> decltype(auto) { return at.vertex_edge_plane(e, End::tail); });
    note_each(head_plane, [&](Index e) -> decltype(auto) { return at.vertex_edge_plane(e, End::head); });
    note_each(left_plane, [&](Index e) -> decltype(auto) { return at.edge_face_plane(e, Side::left); });
    note_each(right_plane, [&](Index e) -> decltype(auto) { return at.edge_face_plane(e, Side::right); });
    note_each(direction, [&](Index e) -> decltype(auto) { return at.direction(e); });
    note_each(length, [&](Index e) -> decltype(auto) { return at.length(e); });
    for (std::size_t k = 0; k < ends_in_order.size(); ++k) {
        const auto field = static_cast<StoredField>(static_cast<std::size_t>(tail) + k);
        note_each(field, [&](Index e) -> decltype(auto) { return end_at(at.ends(e), k); });
    }
    note_each(face_plane, [&](Index f) -> decltype(auto) { return at.face_plane(f); });
    note_each(face_offset, [&](Index f) -> decltype(auto) { return rings.face_offset_at(f); });
    note_each(neighbour, [&](Index i) -> decltype(auto) { return rings.neighbour_at(i); });
    note_each(vertex_ring, [&](Index i) -> decltype(auto) { return rings.vertex_ring_at(i); });
    note_each(face_ring, [&](Index i) -> decltype(auto) { return rings.face_ring_at(i); });
    return mapper.take();
}

}  // namespace edgewise
