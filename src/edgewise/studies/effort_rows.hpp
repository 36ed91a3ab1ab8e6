// SPDX-License-Identifier: MIT
//
// The effort run: what the queries of one scene and shape take (effort.hpp), of several table types,
// algorithms and peers, as rows of the store under a scene called `effort` and the kind of
// the scene.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/studies/effort.hpp"

namespace edgewise::studies {

/// What the scene names of these rows begin with.

/// Whose first two levels Callgrind simulates when nobody says otherwise.
inline constexpr const char* effort_machine = "skylake_sp";

/// What is asked when nobody says otherwise: pairs that turn as in a simulation, large enough to climb on.
inline const CellChoice effort_cell = {.scene = "tumble",
                                       .shape = "sphere386",
                                       .parameters = {{"rotation_step", 0.1}},
                                       .queries = 200,
                                       .checked = 50};

struct EffortPlan {
    CellChoice cell = effort_cell;  ///< scene, shape, parameters, queries, seed: of every row
    std::vector<const bench::TableType*> types, peers;
    std::vector<std::string> algorithms;
    measure::MachineChoice machine;
};

/// One row, ready for a store.
struct EffortRow {
    store::CellRow cell;
    std::vector<store::FigureRow> figures;
};

/// What a row is of, and how it is asked for.
struct EffortContender {
    const bench::TableType* type;
    CellChoice choice;
};

/// In the order of the rows: table types that serve an algorithm, then peers.
[[nodiscard]] std::vector<EffortContender> contenders(const EffortPlan& plan);

/// The machine's first two levels as Callgrind simulates them, or why it cannot.
[[nodiscard]] measure::Expected<measure::CacheGeometry> geometry_of(const measure::MachineChoice& choice);

/// How many rows a plan makes: table types that serve an algorithm, then peers.
[[nodiscard]] std::size_t effort_rows(const EffortPlan& plan);

/// Every figure is a number or none with a reason. `machine`: its name, for figures of caches.
[[nodiscard]] std::vector<store::FigureRow> effort_figures(const Effort& effort, const std::string& machine);

/// Rows of which `wanted` is true, examined one after the other, then counted several at a time. `on_row` is
/// notified of each with its place in the plan's order, one at a time. False when it was stopped before the
/// last.
[[nodiscard]] bool run_effort(const EffortPlan& plan,
                              const std::function<bool(const store::CellRow&)>& wanted,
                              const std::function<void(std::size_t place, const EffortRow&)>& on_row,
                              const std::atomic<bool>& stop);

/// Into the store, but for rows that are counted there already. Otherwise as above.
[[nodiscard]] bool store_effort(const EffortPlan& plan, const std::string& build, store::Store& store,
                                const std::function<void(std::size_t place, const EffortRow&)>& on_row,
                                const std::atomic<bool>& stop);

}  // namespace edgewise::studies
