// SPDX-License-Identifier: MIT
//
// The effort run: the work of the queries of one scene and shape (effort.hpp), for several table types,
// algorithms and peers, as rows of the store of store::Run::effort.
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

/// Default machine: Callgrind simulates its first two levels.
inline constexpr const char* effort_machine = "skylake_sp";

/// Default cell: pairs that turn as in a simulation, with bodies large enough to climb on.
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

/// Table type and algorithm, or peer, of a row, and the choice that runs it.
struct EffortContender {
    const bench::TableType* type;
    CellChoice choice;
};

/// Returns the contenders in the order of the rows: table types with their algorithms, then peers.
[[nodiscard]] std::vector<EffortContender> contenders(const EffortPlan& plan);

/// Returns the machine's first two levels as Callgrind simulates them, or why it cannot.
[[nodiscard]] measure::Expected<measure::CacheGeometry> geometry_of(const measure::MachineChoice& choice);

/// Returns how many rows a plan makes: table types that support an algorithm, then peers.
[[nodiscard]] std::size_t effort_rows(const EffortPlan& plan);

/// Returns figures, each a number or the reason for none. `machine`: its name, for figures of caches.
[[nodiscard]] std::vector<store::FigureRow> effort_figures(const Effort& effort, const std::string& machine);

/// Examines rows for which `wanted` is true one after the other, then counts several at a time. Calls
/// `on_row` for each, one at a time, with its place in the plan's order. Returns false if it was stopped
/// before the last row.
[[nodiscard]] bool run_effort(const EffortPlan& plan,
                              const std::function<bool(const store::CellRow&)>& wanted,
                              const std::function<void(std::size_t place, const EffortRow&)>& on_row,
                              const std::atomic<bool>& stop);

/// Runs as run_effort and writes to the store; skips rows that are already counted there.
[[nodiscard]] bool store_effort(const EffortPlan& plan, const std::string& build, store::Store& store,
                                const std::function<void(std::size_t place, const EffortRow&)>& on_row,
                                const std::atomic<bool>& stop);

}  // namespace edgewise::studies
