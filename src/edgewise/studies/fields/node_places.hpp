// SPDX-License-Identifier: MIT
//
// A trace told again as if the nodes of a table had other records: the layout `grouped_nodes`. A node's
// further records are reached through a pointer in it, which is a read of its own.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "edgewise/layout_parts/node_records.hpp"
#include "edgewise/studies/fields/field_places.hpp"

namespace edgewise::studies {

class GroupedNodePlaces final : public FieldPlaces {
  public:
    /// maps: of tables of nodes, whose addresses tell in which order the nodes were made.
    GroupedNodePlaces(const std::vector<FieldMap>& maps, const FieldGroups& groups);

    void tell(const measure::TracedAccess& as_was, const FieldAccess& field,
              measure::TraceListener& listener) const override;
    [[nodiscard]] std::uint64_t taken() const override { return taken_; }

  private:
    /// By number of the node, as FieldPlace::element has it.
    struct Nodes {
        std::vector<std::uint64_t> at;       ///< bytes from the first table's start
        std::vector<std::uint32_t> created;  ///< how many of its kind were made before it
    };
    struct Table {
        NodeRecords records;
        std::array<Nodes, node_kind_count> nodes;
        std::array<std::uint64_t, node_field_count>
            further{};  ///< by field: the first further record that has it
        std::array<std::uint64_t, node_field_count> stride{};  ///< likewise: from one to the next
    };

    [[nodiscard]] Table make_table(const FieldMap& map, const FieldGroups& groups);
    [[nodiscard]] std::uint64_t take(std::uint64_t bytes, std::uint64_t alignment);

    std::vector<Table> tables_;
    std::uint64_t taken_ = 0;
};

}  // namespace edgewise::studies
