// SPDX-License-Identifier: MIT
//
// Nodes with grouped fields: the first group of a kind of node is the node, to which others point; each
// further group is a record of its own, and the node ends with a pointer to it.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/table/body_facts.hpp"

namespace edgewise {

/// Place of a field: its offset in its record, in bytes. `link`: for a further record the offset of the
/// pointer to it in the node; 0 for the node itself, which begins with a field.
struct NodeFieldPlace {
    std::uint16_t offset = 0, link = 0;
};

struct NodeRecord {
    NodeKind kind{};
    std::uint16_t link = 0;  ///< the link of its fields
    BlockPlan::RecordSize size{0, 1};
};

struct NodeRecords {
    std::array<NodeFieldPlace, node_field_count> places{};
    std::array<NodeRecord, node_field_count> records{};  ///< records of a kind are adjacent, the node first
    std::size_t count = 0;

    /// holds(field): true if the nodes have it; a table for support points has no planes.
    template <class Holds>
    NodeRecords(const FieldGroups& groups, std::span<const RecordField> sized, const Holds& holds) {
        groups.for_each([&](std::span<const std::uint8_t> group) {
            std::array<std::uint8_t, node_field_count> held{};
            std::size_t held_count = 0;
            for (const std::uint8_t field : group)
                if (holds(field)) held[held_count++] = field;
            if (held_count > 0) add({{held.data(), held_count}, sized});
        });
    }

    [[nodiscard]] std::span<const NodeRecord> all() const { return {records.data(), count}; }
    [[nodiscard]] const NodeRecord& node(NodeKind kind) const {
        const auto found = find(kind);
        assert(found != count);
        return records[found];
    }

    /// Number of further records of a node of this kind.
    [[nodiscard]] std::size_t further(NodeKind kind) const {
        std::size_t all_of_kind = 0;
        for (const NodeRecord& record : all()) all_of_kind += record.kind == kind;
        return all_of_kind - 1;
    }

  private:
    [[nodiscard]] std::size_t find(NodeKind kind) const {
        std::size_t i = 0;
        while (i < count && records[i].kind != kind) ++i;
        return i;
    }

    void add(const GroupRecord& group) {
        const NodeKind kind = node_field_infos[group.fields[0]].kind;
        const std::size_t node = find(kind);
        NodeRecord record{kind, 0, group.size};
        if (node == count) {
            record.size = padded(group.size.bytes);
        } else {
            record.link = static_cast<std::uint16_t>(records[node].size.bytes);
            records[node].size = padded(records[node].size.bytes + sizeof(void*));
        }
        for (std::size_t i = 0; i < group.count; ++i)
            places[group.fields[i]] = {static_cast<std::uint16_t>(group.offset[i]), record.link};
        records[count++] = record;
    }
    static BlockPlan::RecordSize padded(std::size_t bytes) {
        constexpr std::size_t to = sizeof(void*);
        return {rounded_up(bytes, to), to};
    }
};

/// Returns true if nodes of a table have the field.
[[nodiscard]] inline bool holds(NodeField field, Parts parts) {
    const NodeKind kind = info_of(field).kind;
    if (parts == Parts::features || kind == NodeKind::vertex) return true;
    return field == NodeField::neighbour || field == NodeField::next_spoke;
}

/// Number of nodes of each kind in a table.
[[nodiscard]] inline std::array<std::size_t, node_kind_count> node_counts(const BodyFacts& n) {
    return {n.vertex_count, n.neighbour_count, n.edge_count(), n.face_ring_count(), n.face_count};
}

/// Purposes of the bytes of a record.
template <class Holds>
[[nodiscard]] Shares shares_of(const NodeRecord& record, const NodeRecords& records,
                               std::span<const RecordField> sized, const Holds& holds) {
    std::array<std::uint8_t, node_field_count> fields{};
    std::size_t count = 0;
    for (std::uint8_t i = 0; i < node_field_count; ++i)
        if (node_field_infos[i].kind == record.kind && records.places[i].link == record.link && holds(i))
            fields[count++] = i;
    std::sort(
        fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(count),
        [&](std::uint8_t a, std::uint8_t b) { return records.places[a].offset < records.places[b].offset; });
    ShareRuns runs;
    for (std::size_t i = 0; i < count; ++i) {
        runs.pad_to(records.places[fields[i]].offset);
        runs.add(node_field_infos[fields[i]].component, sized[fields[i]].bytes);
    }
    if (record.link != 0) return runs.take();
    const std::size_t links = records.further(record.kind) * sizeof(void*);
    runs.pad_to(record.size.bytes - links);
    runs.add(Component::topology, links);
    return runs.take();
}

}  // namespace edgewise
