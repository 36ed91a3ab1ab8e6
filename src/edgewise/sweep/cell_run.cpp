// SPDX-License-Identifier: MIT
#include "edgewise/sweep/cell_run.hpp"

#include <fmt/format.h>

#include "edgewise/bench/cold_starts.hpp"
#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/counters/software_watch.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/sweep/heap_of_cell.hpp"
#include "edgewise/sweep/measure_steps.hpp"
#include "edgewise/sweep/trace_scene.hpp"
#include "edgewise/sweep/verify.hpp"
#include "edgewise/sweep/watch_algorithm.hpp"

namespace edgewise::sweep {

namespace {

/// An odd number, for a median that was measured.
constexpr int build_repetitions = 15;

Parts parts_of(const std::string& algorithm) {
    for (const bench::AlgorithmInfo& info : bench::algorithms()) {
        if (info.name == algorithm) return info.parts;
    }
    return Parts::features;
}

}  // namespace

CellRun::CellRun(const bench::TableType& type, std::string algorithm, const Axes& axes, store::CellRow row)
    : type_(type), axes_(axes), row_(std::move(row)), runner_(type.make_runner(algorithm)) {
    runner_->set_options(axes.query);
    runner_->set_needs(axes.needs);
    runner_->place_tables(axes.tables);
    row_.axes = axes.text();
    row_.algorithm = std::move(algorithm);
    row_.layout = type.layout;
    row_.precision = type.precision;
    row_.table = type.name;
}

void CellRun::verify(SharedQueries& shared) {
    const scene::Workload& workload = shared.workload();
    const bool table_each = axes_.tables.sharing == bench::Sharing::per_instance ||
                            (axes_.tables.sharing == bench::Sharing::as_scene && workload.table_each);
    const std::span<const std::uint32_t> instances =
        table_each ? std::span<const std::uint32_t>(workload.instances) : std::span<const std::uint32_t>();
    if (const std::string error = runner_->load(workload.bodies, instances); !error.empty()) {
        make_unavailable(error);
        return;
    }
    const std::vector<Distance> answers = runner_->answer(workload);
    counts_ =
        count_answers(answers, workload.warm ? bench::cold_starts(workload) : std::vector<std::uint8_t>{});
    measure::LineCounter lines;
    runner_->trace(workload, measure::traced_queries, lines);
    touched_ = lines.sums();
    double sum = 0;
    for (const Distance& answer : answers) {
        in_contact_.push_back(answer.status != Status::separated);
        distances_.push_back(sum += answer.distance);
    }
    checked_ = check_answers(shared, runner_->stored_bodies(), answers, type_.eps, axes_.query);
    row_.reason = what_is_wrong(shared, checked_, type_.eps);
    row_.status = row_.reason.empty() ? "verified" : "failed";
}

void CellRun::hold_against_answers(const bench::PassSum& sum, const char* pass) {
    if (sum.queries > 0 && distances_[sum.queries - 1] == sum.distances) return;
    row_.status = "failed";
    row_.reason = fmt::format("the {} pass gave other answers: distances add up to {}, not {}", pass,
                              sum.distances, sum.queries > 0 ? distances_[sum.queries - 1] : 0);
}

void CellRun::trace(const SharedQueries& shared, std::size_t queries) {
    if (!models_caches()) return;
    if (!verified()) {
        trace_.reason = "the cell was not verified";
        trace_.remedy = "see the cell's own reason";
        return;
    }
    trace_ = trace_scene(*runner_, shared.workload(), queries, machines_);
    if (trace_.traced()) hold_against_answers({trace_.answered, trace_.distances}, "traced");
}

/// In the steady state: tables and pairs were all used before.
void CellRun::count(const SharedQueries& shared) {
    if (!verified()) return;
    static const measure::Cpu cpu = measure::read_machine().cpu;
    const std::function<bench::PassSum()> pass = runner_->prepared_pass(shared.workload());
    bench::PassSum last = pass();
    const std::function<void()> again = [&] { last = pass(); };
    const std::size_t queries = shared.workload().queries.size();
    counted_ = measure::count_software(again, queries, cpu);
    const measure::CountedPass hardware = measure::count_pass(again, queries, cpu);
    counted_.insert(counted_.end(), hardware.records.begin(), hardware.records.end());
    hold_against_answers(last, "counted");
}

void CellRun::study(const SharedQueries& shared) {
    if (!verified()) return;
    if (!row_.axes.empty()) {
        costs_.reason = work_.reason = "measured for the cell without further axes";
        return;
    }
    costs_ = step_costs(*runner_, shared.workload());
    work_ = algorithm_work(row_.algorithm, type_, shared);
}

measure::Timing CellRun::time(const SharedQueries& shared, double clock_cost_ns) const {
    return runner_->time(shared.workload(), in_contact_, clock_cost_ns);
}

std::vector<store::FigureRow> CellRun::figures(const SharedQueries& shared, SizeFamily& sizes,
                                               std::span<const measure::Round> rounds) const {
    std::vector<store::FigureRow> result;
    if (row_.status == "unavailable") return result;
    measure::Subject subject;
    const measure::BuildTimes build = runner_->build_times(build_repetitions);
    subject.table = table_bytes(runner_->ledger(), runner_->stored_bodies()[0]);
    subject.memory = runner_->memory();
    subject.build = build;
    subject.touched = touched_;
    subject.trace = &trace_;
    subject.heap = heap_of_cell(type_, parts_of(row_.algorithm), runner_->stored_bodies()[0],
                                shared.workload(), runner_->pair_bytes());
    subject.sizes = sizes.of(type_, parts_of(row_.algorithm));
    subject.checked = checked_;
    subject.counts = counts_;
    subject.rounds = rounds;
    subject.counted = counted_;
    subject.costs = costs_;
    subject.work = work_;
    for (const auto& probe : measure::registered_probes()) {
        for (measure::Figure& figure : probe->figures(subject)) {
            result.push_back({std::move(figure), std::string(probe->name())});
        }
    }
    return result;
}

}  // namespace edgewise::sweep
