// SPDX-License-Identifier: MIT
#include "edgewise/sweep/cell_run.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "edgewise/bench/cell.hpp"
#include "edgewise/sweep/body_heat.hpp"

namespace edgewise::sweep {

CellRun::CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes,
                 store::CellRow row, const Polyhedron& body)
    : cell_(type, algorithm, axes), axes_(axes), row_(std::move(row)) {
    row_.axes = axes.text();
    row_.algorithm = algorithm;
    row_.layout = type.layout;
    row_.precision = type.precision;
    row_.table = type.name;
    bench::name_cell(row_, body);
}

void CellRun::make_unavailable(const std::string& reason) {
    row_.status = store::CellStatus::unavailable;
    row_.reason = reason;
}

void CellRun::verify(SharedQueries& shared) {
    const scene::Workload& workload = axes_.starts_cold ? shared.cold_workload() : shared.workload();
    if (cell_.type().is_peer && axes_.needs == Needs::nearer) {
        make_unavailable("other libraries are not asked whether bodies are nearer than a margin");
        return;
    }
    if (const std::string error = cell_.load(workload); !error.empty()) {
        make_unavailable(error);
        return;
    }
    shared_ = &shared;
    row_.queries = workload.queries.size();  // more than asked for where a scene has to take so many steps
    cell_.check(shared);
    row_.reason = cell_.wrong();
    // A peer's errors, and those of V-Clip as published, are figures; they are no failure of this program.
    row_.status = cell_.type().is_peer || !axes_.query.hardened ? store::CellStatus::judged
                  : row_.reason.empty()                         ? store::CellStatus::verified
                                                                : store::CellStatus::failed;
}

void CellRun::measure(Stage stage, std::span<const measure::Round> rounds) {
    if (!shared_) return;
    const bench::ProbedCell cell{.type = cell_.type(),
                                 .algorithm = bench::algorithm_called(row_.algorithm),
                                 .runner = cell_.runner(),
                                 .workload = cell_.workload(),
                                 .plain = row_.axes.empty(),
                                 .needs = axes_.needs,
                                 .verified = verified(),
                                 .checked_positions = shared_->checked(),
                                 .checked = cell_.checked(),
                                 .counts = cell_.counts(),
                                 .rounds = rounds,
                                 .caches = caches_};
    for (const bench::Probe& probe : bench::registered_probes()) {
        if (probe.beside_others != (stage == Stage::beside_others)) continue;
        if (cell_.type().is_peer && !probe.of_peers) continue;
        if (!only_.empty() && std::ranges::find(only_, probe.name) == only_.end()) continue;
        bench::Findings found = probe.measure(cell);
        if (found.passed) hold_against_answers(*found.passed, probe.name);
        for (measure::Figure& figure : found.figures)
            figures_.push_back({std::move(figure), std::string(probe.name)});
    }
}

std::string CellRun::heat_on_body() const {
    const bench::Runner& runner = cell_.runner();
    const bool traced = !caches_.machines.empty() && runner.table_allocator().base();
    if (!verified() || !shared_ || !row_.axes.empty() || !traced || !shows_heat(cell_.type(), row_.vertices))
        return {};
    bench::FeatureHeat heat(runner.memory_maps());
    static_cast<void>(runner.trace(caches_.queries > 0 ? bench::TraceExtent(caches_.queries, caches_.steps)
                                                       : bench::TraceExtent::everything(),
                                   heat));
    return heat_json(heat);
}

void CellRun::hold_against_answers(const bench::PassSum& sum, std::string_view probe) {
    const double expected = cell_.distances(sum.queries);
    if (sum.queries > 0 && expected == sum.distances) return;
    row_.status = store::CellStatus::failed;
    row_.reason = fmt::format("the pass of probe {} gave other answers: distances add up to {}, not {}",
                              probe, sum.distances, expected);
}

}  // namespace edgewise::sweep
