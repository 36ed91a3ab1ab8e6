// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/node_groups.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/studies/fields/node_places.hpp"

namespace edgewise::studies {

namespace {

using Fields = std::vector<std::uint8_t>;
/// The records of each kind of node; an empty one stands for a record that a field may be moved to.
using KindGroups = std::array<std::vector<Fields>, node_kind_count>;

FieldGroups groups_from(const KindGroups& kinds) {
    FieldGroups groups;
    for (const auto& records : kinds)
        for (const Fields& record : records) groups.add(record);
    return groups;
}

KindGroups whole() {
    KindGroups kinds;
    for (auto& records : kinds) records.emplace_back();
    for (std::uint8_t field = 0; field < node_field_count; ++field)
        kinds[static_cast<std::size_t>(node_field_infos[field].kind)].front().push_back(field);
    return kinds;
}

/// Lines first, then bytes.
using Cost = std::pair<std::uint64_t, std::uint64_t>;

class NodeSearch {
  public:
    explicit NodeSearch(const FieldTrace& trace) : trace_(trace.first(judged_queries)) {}

    [[nodiscard]] FieldGroups run() {
        best_ = whole();
        cost_ = cost(best_);
        for (bool better = true; better;) {
            better = false;
            for (std::size_t kind = 0; kind < node_kind_count; ++kind) better = improve(kind) || better;
        }
        return groups_from(best_);
    }

  private:
    [[nodiscard]] Cost cost(const KindGroups& kinds) const {
        const GroupedNodePlaces places(trace_.maps, groups_from(kinds));
        measure::LineCounter lines;
        replay(trace_, places, lines);
        return {lines.sums().all.lines, places.taken()};
    }

    bool take_if_better(const KindGroups& kinds) {
        const Cost cost = this->cost(kinds);
        if (cost >= cost_) return false;
        cost_ = cost;
        best_ = kinds;
        return true;
    }

    /// Every field to every other place in the records of its kind, and to a record of its own.
    bool improve(std::size_t kind) {
        bool better = false;
        for (std::uint8_t field = 0; field < node_field_count; ++field) {
            if (static_cast<std::size_t>(node_field_infos[field].kind) != kind) continue;
            const std::size_t records = best_[kind].size();
            for (std::size_t record = 0; record <= records; ++record)
                for (std::size_t place = 0; place <= size_of(kind, record); ++place)
                    better = take_if_better(moved(kind, field, record, place)) || better;
        }
        return better;
    }
    [[nodiscard]] std::size_t size_of(std::size_t kind, std::size_t record) const {
        return record < best_[kind].size() ? best_[kind][record].size() : 0;
    }

    [[nodiscard]] KindGroups moved(std::size_t kind, std::uint8_t field, std::size_t record,
                                   std::size_t place) const {
        KindGroups kinds = best_;
        std::vector<Fields>& records = kinds[kind];
        for (Fields& fields : records) std::erase(fields, field);
        if (record >= records.size()) records.emplace_back();
        Fields& to = records[std::min(record, records.size() - 1)];
        to.insert(to.begin() + static_cast<std::ptrdiff_t>(std::min(place, to.size())), field);
        std::erase_if(records, [](const Fields& fields) { return fields.empty(); });
        return kinds;
    }

    FieldTrace trace_;
    KindGroups best_;
    Cost cost_;
};

}  // namespace

FieldGroups best_node_groups(const FieldTrace& trace) { return NodeSearch(trace).run(); }

FieldGroups whole_nodes() { return groups_from(whole()); }

}  // namespace edgewise::studies
