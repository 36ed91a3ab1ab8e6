// SPDX-License-Identifier: MIT
//
// The nodes of `linked`, each in one record or several, by groups of fields that are chosen at run time:
// which fields share a record is a list, not a type. The first group of a kind of node is the node, which
// others point to; it is allocated by itself, as in `linked`, and ends with a pointer to each of the node's
// further records. Further records of one kind lie side by side in one piece of memory, so that cold fields
// do not lie between hot ones. The split is that of Chilimbi, Davidson and Larus ("Cache-conscious structure
// definition", 1999), who keep the cold fields behind a pointer too.
//
// One group for each kind of node, its fields in their order, equals `linked`, byte for byte. The usual
// groups, used unless others are chosen, are what `edgewise fields` advised for `linked_f64` and V-Clip in
// the scene `tumble`: no node is split, for a pointer costs more than it saves, but fields that are read
// together no longer straddle lines; at 386 vertices 38.7 lines per query instead of 44.6.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <string_view>
#include <type_traits>
#include <vector>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/layout_parts/linked_table.hpp"
#include "edgewise/layout_parts/node_records.hpp"

namespace edgewise {

/// Groups for a table without a choice of its own.
[[nodiscard]] inline const FieldGroups& usual_node_groups() {
    using enum NodeField;
    static const FieldGroups groups = {
        {index, next_vertex, spokes, point},
        {next_spoke, vertex_plane, vertex_edge, neighbour},
        {left, direction, head_cone, tail, head, tail_cone, length, right, left_cone, right_cone},
        {side_edge, next_side, side_plane},
        {face_plane, cone, next_face}};
    return groups;
}

template <class StoredScalar>
class GroupedNodes {
  public:
    using Stored = StoredScalar;
    using Nodes = LinkedNodes<Stored>;

    /// Returns the field. If it is in a further record, the pointer to the record is read first.
    template <NodeField field, class Loader, class Node>
    [[nodiscard]] auto& at(const Loader& loader, Node* node, Field name) const {
        using Value = NodeValue<Stored, field>;
        using Byte = std::conditional_t<std::is_const_v<Node>, const std::byte, std::byte>;
        using Placed = std::conditional_t<std::is_const_v<Node>, const Value, Value>;
        const NodeFieldPlace& place = places_[static_cast<std::size_t>(field)];
        Byte* record = reinterpret_cast<Byte*>(node);
        if (place.link != 0)
            record = loader.load(*reinterpret_cast<std::byte* const*>(record + place.link), name);
        return *reinterpret_cast<Placed*>(record + place.offset);
    }

    /// Places fields, and takes memory for the further records of all nodes.
    void prepare(const BodyFacts& n, std::pmr::memory_resource& owner) {
        parts_ = n.parts;
        const NodeRecords records = this->records();
        places_ = records.places;
        const auto counts = node_counts(n);
        for (std::size_t i = 0; i < records.count; ++i) {
            const NodeRecord& record = records.records[i];
            const auto count = static_cast<std::uint32_t>(counts[static_cast<std::size_t>(record.kind)]);
            if (record.link == 0 || count == 0) continue;
            further_[i].first =
                static_cast<std::byte*>(owner.allocate(record.size.bytes * count, record.size.alignment));
            further_[i].count = count;
        }
    }
    void release(std::pmr::memory_resource& owner) const {
        for_each_further([&](const NodeRecord& record, const Further& further) {
            owner.deallocate(further.first, record.size.bytes * further.count, record.size.alignment);
        });
    }

    /// Makes a node with null pointers, except those to its further records.
    template <class Node>
    [[nodiscard]] Node* make(std::pmr::memory_resource& owner) {
        constexpr NodeKind kind = kind_of<Stored, Node>();
        const NodeRecords records = this->records();
        const auto size = records.node(kind).size;
        auto* const node = static_cast<std::byte*>(owner.allocate(size.bytes, size.alignment));
        std::memset(node, 0, size.bytes);
        for (std::size_t i = 0; i < records.count; ++i) {
            const NodeRecord& record = records.records[i];
            if (record.kind != kind || record.link == 0) continue;
            assert(further_[i].used < further_[i].count);
            std::byte* const at = further_[i].first + further_[i].used++ * record.size.bytes;
            std::memset(at, 0, record.size.bytes);
            std::memcpy(node + record.link, &at, sizeof(at));
        }
        return reinterpret_cast<Node*>(node);
    }
    template <class Node>
    void give_back(Node* node, std::pmr::memory_resource& owner) const {
        const auto size = records().node(kind_of<Stored, Node>()).size;
        owner.deallocate(node, size.bytes, size.alignment);
    }

    template <class Node>
    void add_piece(const Node* node, std::vector<Piece>& to) const {
        const NodeRecords records = this->records();
        const NodeRecord& record = records.node(kind_of<Stored, Node>());
        to.push_back(
            {reinterpret_cast<const std::byte*>(node), record.size.bytes, 1, shares_in(records, record)});
    }
    void add_further_pieces(std::vector<Piece>& to) const {
        const NodeRecords records = this->records();
        for_each_further([&](const NodeRecord& record, const Further& further) {
            to.push_back({further.first, record.size.bytes, further.count, shares_in(records, record)});
        });
    }

  private:
    /// The further records of all nodes of a kind.
    struct Further {
        std::byte* first = nullptr;
        std::uint32_t count = 0, used = 0;
    };

    [[nodiscard]] auto held() const {
        return [parts = parts_](std::uint8_t field) { return holds(static_cast<NodeField>(field), parts); };
    }
    [[nodiscard]] NodeRecords records() const { return {groups_, sized_node_fields<Stored>(), held()}; }
    [[nodiscard]] Shares shares_in(const NodeRecords& records, const NodeRecord& record) const {
        return shares_of(record, records, sized_node_fields<Stored>(), held());
    }
    template <class Use>
    void for_each_further(Use use) const {
        const NodeRecords records = this->records();
        for (std::size_t i = 0; i < records.count; ++i)
            if (further_[i].first) use(records.records[i], further_[i]);
    }

    std::array<NodeFieldPlace, node_field_count> places_{};
    FieldGroups groups_ = FieldsGroupedBy<NodeField>::chosen_or(usual_node_groups());
    Parts parts_ = Parts::support;
    std::array<Further, node_field_count> further_{};  ///< indexed by the number of the record
};

template <Precision P, class Loader = Direct>
class grouped_nodes : public LinkedTable<GroupedNodes<typename P::Stored>, P, Loader> {
    using Base = LinkedTable<GroupedNodes<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "grouped_nodes";
    static constexpr std::string_view stores =
        "the nodes of linked in records by groups that are chosen at run time";

    using Base::Base;
};

}  // namespace edgewise
