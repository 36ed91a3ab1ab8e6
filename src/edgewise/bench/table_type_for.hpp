// SPDX-License-Identifier: MIT
//
// Builds the registry entry of one table type: which algorithms it can serve is asked of the contract's
// concepts.
#pragma once

#include <limits>
#include <tuple>

#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/runner_for.hpp"
#include "edgewise/layout_parts/input_order.hpp"
#include "edgewise/table/pieces.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise::bench {

using Algorithms = std::tuple<VClip, Gjk>;

/// Support points are enough for the algorithm, or the table has features.
template <class Algorithm, class Table>
concept HasPartsFor = Algorithm::parts == Parts::support || FeatureTable<Table>;

template <class Algorithm, class Table>
concept Serves = MeasuredTable<Table> && HasPartsFor<Algorithm, Table>;

/// Sets the entries that depend on the layout alone.
template <class Table>
void describe(TableType& type) {
    using P = typename Table::PrecisionType;
    type.layout = Table::name;
    type.precision = P::name;
    type.name = type.layout + "_" + type.precision;
    type.stores = Table::stores;
    type.derives = Table::derives;
    type.storage = storage_name<Table>();
    type.single_storage = std::is_same_v<typename P::Stored, float>;
    if constexpr (FeatureTable<Table>) type.rounded_planes = vclip::rounded_planes<Table>;
    type.stored_body = stored_body<Table>;
    type.eps = std::numeric_limits<typename P::Compute>::epsilon();
    type.make_table = [](const Polyhedron& body, Parts parts) {
        return std::static_pointer_cast<const void>(std::make_shared<const Table>(body, parts));
    };
    type.ledger = [](const Polyhedron& body, Parts parts) { return Table(body, parts).ledger(); };
    if constexpr (requires { Table::vertex_order; }) {
        type.input_order_bytes = [](const Polyhedron& body) {
            return Table(body, Parts::features, {}, InputOrder::kept).ledger()[Component::input_order];
        };
    }
    type.memory_map = [](const Polyhedron& body, Parts parts) {
        return memory_map(Table(body, parts).pieces());
    };
}

/// Calls use(algorithm) for each that the table serves.
template <class Table, class Use>
void for_each_served(Use use) {
    std::apply(
        [&]<class... Algorithm>(Algorithm... algorithm) {
            (..., [&] {
                if constexpr (Serves<Algorithm, Table>) use(algorithm);
            }());
        },
        Algorithms{});
}

/// TracedTable: the same layout with a loader that reports to a TraceSink.
template <class Table, class TracedTable>
[[nodiscard]] TableType table_type_for() {
    TableType type;
    describe<Table>(type);
    for_each_served<Table>(
        [&]<class Algorithm>(Algorithm) { type.algorithms.emplace_back(Algorithm::name); });
    type.make_runner = [](std::string_view name) {
        std::unique_ptr<Runner> runner;
        for_each_served<Table>([&]<class Algorithm>(Algorithm) {
            if (name == Algorithm::name)
                runner = std::make_unique<RunnerFor<Algorithm, Table, TracedTable>>();
        });
        return runner;
    };
    return type;
}

}  // namespace edgewise::bench
