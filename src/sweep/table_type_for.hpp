// SPDX-License-Identifier: MIT
//
// Builds the registry entry of one table type: which algorithms it can serve is asked of the contract's
// concepts.
#pragma once

#include <limits>
#include <tuple>

#include "edgewise/sweep/registry.hpp"
#include "edgewise/sweep/runner_for.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {

using Algorithms = std::tuple<VClip, Gjk>;

template <class Algorithm, class Table>
concept Serves = SupportTable<Table> &&(Algorithm::parts == Parts::support || FeatureTable<Table>);

template <class Table>
[[nodiscard]] TableType table_type_for() {
    using P = typename Table::PrecisionType;
    TableType type;
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
    type.ledger = [](const Polyhedron& body, Parts parts) { return Table(body, parts).ledger(); };

    std::apply(
        [&]<class... Algorithm>(Algorithm...) {
            (..., [&] {
                if constexpr (Serves<Algorithm, Table>) type.algorithms.emplace_back(Algorithm::name);
            }());
        },
        Algorithms{});
    type.make_runner = [](std::string_view name) {
        std::unique_ptr<Runner> runner;
        std::apply(
            [&]<class... Algorithm>(Algorithm...) {
                (..., [&] {
                    if constexpr (Serves<Algorithm, Table>) {
                        if (name == Algorithm::name) runner = std::make_unique<RunnerFor<Algorithm, Table>>();
                    }
                }());
            },
            Algorithms{});
        return runner;
    };
    return type;
}

}  // namespace edgewise
