// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/node_places.hpp"

#include <algorithm>

namespace edgewise::studies {

namespace {

/// A node, and where it was. What lies beside nodes comes before them.
struct PlacedNode {
    std::uint64_t at = 0;
    NodeKind kind{};
    std::uint32_t element = 0;
};

/// In the order in which an arena gave them out.
std::vector<PlacedNode> nodes_in_order(const FieldMap& map) {
    std::array<std::vector<PlacedNode>, node_kind_count> by_kind;
    for (const FieldPlace& place : map.places) {
        const NodeKind kind = node_field_infos[place.field].kind;
        auto& nodes = by_kind[static_cast<std::size_t>(kind)];
        if (nodes.size() <= place.element) nodes.resize(place.element + 1);
        PlacedNode& node = nodes[place.element];
        node = {std::max(node.at, place.at), kind, place.element};
    }
    std::vector<PlacedNode> all;
    for (const auto& nodes : by_kind) all.insert(all.end(), nodes.begin(), nodes.end());
    std::sort(all.begin(), all.end(), [](const PlacedNode& a, const PlacedNode& b) { return a.at < b.at; });
    return all;
}

}  // namespace

GroupedNodePlaces::GroupedNodePlaces(const std::vector<FieldMap>& maps, const FieldGroups& groups) {
    for (const FieldMap& map : maps) tables_.push_back(make_table(map, groups));
}

std::uint64_t GroupedNodePlaces::take(std::uint64_t bytes, std::uint64_t alignment) {
    const std::uint64_t start = rounded_up(taken_, alignment);
    taken_ = start + bytes;
    return start;
}

GroupedNodePlaces::Table GroupedNodePlaces::make_table(const FieldMap& map, const FieldGroups& groups) {
    std::array<bool, node_field_count> held{};
    for (const FieldPlace& place : map.places) held[place.field] = true;
    Table table{NodeRecords(groups, map.fields, [&](std::uint8_t field) { return held[field]; }), {}, {}, {}};
    const std::vector<PlacedNode> nodes = nodes_in_order(map);
    for (const PlacedNode& node : nodes) {
        Nodes& of_kind = table.nodes[static_cast<std::size_t>(node.kind)];
        of_kind.at.resize(std::max<std::size_t>(of_kind.at.size(), node.element + 1));
        of_kind.created.resize(of_kind.at.size());
    }
    for (const NodeRecord& record : table.records.all()) {
        const std::size_t count = table.nodes[static_cast<std::size_t>(record.kind)].at.size();
        if (record.link == 0 || count == 0) continue;
        const std::uint64_t first = take(record.size.bytes * count, record.size.alignment);
        for (std::size_t field = 0; field < node_field_count; ++field) {
            const bool is_in = node_field_infos[field].kind == record.kind &&
                               table.records.places[field].link == record.link;
            if (!is_in) continue;
            table.further[field] = first;
            table.stride[field] = record.size.bytes;
        }
    }
    std::array<std::uint32_t, node_kind_count> made{};
    for (const PlacedNode& node : nodes) {
        const auto kind = static_cast<std::size_t>(node.kind);
        const auto size = table.records.node(node.kind).size;
        table.nodes[kind].at[node.element] = take(size.bytes, size.alignment);
        table.nodes[kind].created[node.element] = made[kind]++;
    }
    return table;
}

void GroupedNodePlaces::tell(const measure::TracedAccess& as_was, const FieldAccess& field,
                             measure::TraceListener& listener) const {
    const Table& table = tables_[field.table];
    const NodeFieldPlace& place = table.records.places[field.field];
    const Nodes& nodes = table.nodes[static_cast<std::size_t>(node_field_infos[field.field].kind)];
    measure::TracedAccess access = as_was;
    access.address = nodes.at[field.element] + place.offset;
    if (place.link != 0) {
        measure::TracedAccess link = as_was;
        link.address = nodes.at[field.element] + place.link;
        link.bytes = sizeof(void*);
        listener.on_access(link);
        access.address = table.further[field.field] +
                         nodes.created[field.element] * table.stride[field.field] + place.offset;
    }
    listener.on_access(access);
}

}  // namespace edgewise::studies
