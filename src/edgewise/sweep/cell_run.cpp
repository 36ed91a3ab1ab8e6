// SPDX-License-Identifier: MIT
#include "edgewise/sweep/cell_run.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "edgewise/bench/cell.hpp"
#include "edgewise/sweep/body_heat.hpp"
#include "edgewise/sweep/verify.hpp"

namespace edgewise::sweep {

CellRun::CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes,
                 store::CellRow row, const Polyhedron& body)
    : type_(type), axes_(axes), row_(std::move(row)), runner_(type.make_runner(algorithm)) {
    runner_->configure(axes);
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
    if (type_.is_peer && axes_.needs == Needs::nearer) {
        make_unavailable("other libraries are not asked whether bodies are nearer than a margin");
        return;
    }
    if (const std::string error = runner_->load(workload); !error.empty()) {
        make_unavailable(error);
        return;
    }
    shared_ = &shared;
    workload_ = &workload;
    row_.queries = workload.queries.size();  // more than asked for where a scene has to take so many steps
    const std::vector<Distance> answers = runner_->answer();
    counts_ =
        count_answers(answers, workload.warm ? bench::cold_starts(workload) : std::vector<std::uint8_t>{});
    double sum = 0;
    for (const Distance& answer : answers) {
        if (axes_.needs > Needs::nearer) in_contact_.push_back(answer.status != Status::separated);
        distances_.push_back(sum += answer.distance);
    }
    checked_ = checked(shared, answers);
    row_.reason = what_is_wrong(shared, checked_, type_.eps);
    // A peer's errors, and those of V-Clip as published, are figures; they are no failure of this program.
    row_.status = type_.is_peer || !axes_.query.hardened ? store::CellStatus::judged
                  : row_.reason.empty()                  ? store::CellStatus::verified
                                                         : store::CellStatus::failed;
}

std::vector<truth::CheckedAnswer> CellRun::checked(SharedQueries& shared,
                                                   std::span<const Distance> answers) const {
    const auto stored = runner_->stored_bodies();
    if (axes_.needs == Needs::nearer)
        return check_nearness(shared, stored, answers, type_.eps, axes_.query,
                              [&](const scene::Query& query) { return runner_->margin(query); });
    QueryOptions asked = axes_.query;
    asked.verdict_only = asked.verdict_only || type_.verdict_only;
    return check_answers(shared, stored, answers, type_.eps, asked);
}

measure::Timing CellRun::time(double clock_cost_ns) const {
    return runner_->time(in_contact_, clock_cost_ns);
}

void CellRun::measure(Stage stage, std::span<const measure::Round> rounds) {
    if (!shared_) return;
    const bench::ProbedCell cell{.type = type_,
                                 .algorithm = bench::algorithm_called(row_.algorithm),
                                 .runner = *runner_,
                                 .workload = *workload_,
                                 .plain = row_.axes.empty(),
                                 .needs = axes_.needs,
                                 .verified = verified(),
                                 .checked_positions = shared_->checked(),
                                 .checked = checked_,
                                 .counts = counts_,
                                 .rounds = rounds,
                                 .caches = caches_};
    for (const bench::Probe& probe : bench::registered_probes()) {
        if (probe.beside_others != (stage == Stage::beside_others)) continue;
        if (type_.is_peer && !probe.of_peers) continue;
        if (!only_.empty() && std::ranges::find(only_, probe.name) == only_.end()) continue;
        bench::Findings found = probe.measure(cell);
        if (found.passed) hold_against_answers(*found.passed, probe.name);
        for (measure::Figure& figure : found.figures)
            figures_.push_back({std::move(figure), std::string(probe.name)});
    }
}

std::string CellRun::heat_on_body() const {
    const bool traced = !caches_.machines.empty() && runner_->table_allocator().base();
    if (!verified() || !shared_ || !row_.axes.empty() || !traced || !shows_heat(type_, row_.vertices))
        return {};
    bench::FeatureHeat heat(runner_->memory_maps());
    static_cast<void>(runner_->trace(caches_.queries > 0 ? bench::TraceExtent(caches_.queries, caches_.steps)
                                                         : bench::TraceExtent::everything(),
                                     heat));
    return heat_json(heat);
}

void CellRun::hold_against_answers(const bench::PassSum& sum, std::string_view probe) {
    const double expected = sum.queries > 0 ? distances_[sum.queries - 1] : 0;
    if (sum.queries > 0 && expected == sum.distances) return;
    row_.status = store::CellStatus::failed;
    row_.reason = fmt::format("the pass of probe {} gave other answers: distances add up to {}, not {}",
                              probe, sum.distances, expected);
}

}  // namespace edgewise::sweep
