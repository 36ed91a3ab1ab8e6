// SPDX-License-Identifier: MIT
#include "edgewise/sweep/cell_run.hpp"

#include <fmt/format.h>

#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/measure/counters/software_watch.hpp"
#include "edgewise/bench/cold_starts.hpp"
#include "edgewise/sweep/heap_of_cell.hpp"
#include "edgewise/sweep/measure_steps.hpp"
#include "edgewise/sweep/trace_scene.hpp"
#include "edgewise/sweep/verify.hpp"
#include "edgewise/sweep/watch_algorithm.hpp"

namespace edgewise {

namespace {

/// An odd number, for a median that was measured.
constexpr int build_repetitions = 15;

Parts parts_of(const std::string& algorithm) {
    for (const AlgorithmInfo& info : algorithms()) {
        if (info.name == algorithm) return info.parts;
    }
    return Parts::features;
}

}  // namespace

Contender::Contender(const TableType& type, std::string algorithm, const Axes& axes, CellRow row)
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

void Contender::verify(Group& group) {
    const Workload& workload = group.workload();
    const bool table_each = axes_.tables.sharing == Sharing::per_instance ||
                            (axes_.tables.sharing == Sharing::as_scene && workload.table_each);
    const std::span<const std::uint32_t> instances =
        table_each ? std::span<const std::uint32_t>(workload.instances) : std::span<const std::uint32_t>();
    if (const std::string error = runner_->load(workload.bodies, instances); !error.empty()) {
        make_unavailable(error);
        return;
    }
    const std::vector<Distance> answers = runner_->answer(workload);
    counts_ = count_answers(answers, workload.warm ? cold_starts(workload) : std::vector<std::uint8_t>{});
    LineCounter lines;
    runner_->trace(workload, traced_queries, lines);
    touched_ = lines.sums();
    double sum = 0;
    for (const Distance& answer : answers) {
        in_contact_.push_back(answer.status != Status::separated);
        distances_.push_back(sum += answer.distance);
    }
    checked_ = check_answers(group, runner_->stored_bodies(), answers, type_.eps, axes_.query);
    row_.reason = what_is_wrong(group, checked_, type_.eps);
    row_.status = row_.reason.empty() ? "verified" : "failed";
}

void Contender::hold_against_answers(const PassSum& sum, const char* pass) {
    if (sum.queries > 0 && distances_[sum.queries - 1] == sum.distances) return;
    row_.status = "failed";
    row_.reason = fmt::format("the {} pass gave other answers: distances add up to {}, not {}", pass,
                              sum.distances, sum.queries > 0 ? distances_[sum.queries - 1] : 0);
}

void Contender::trace(const Group& group, std::size_t queries) {
    if (!models_caches()) return;
    if (!verified()) {
        trace_.reason = "the cell was not verified";
        trace_.remedy = "see the cell's own reason";
        return;
    }
    trace_ = trace_scene(*runner_, group.workload(), queries, machines_);
    if (trace_.traced()) hold_against_answers({trace_.answered, trace_.distances}, "traced");
}

/// In the steady state: tables and pairs were all used before.
void Contender::count(const Group& group) {
    if (!verified()) return;
    static const Cpu cpu = read_machine().cpu;
    const std::function<PassSum()> pass = runner_->prepared_pass(group.workload());
    PassSum last = pass();
    const std::function<void()> again = [&] { last = pass(); };
    const std::size_t queries = group.workload().queries.size();
    counted_ = count_software(again, queries, cpu);
    const CountedPass hardware = count_pass(again, queries, cpu);
    counted_.insert(counted_.end(), hardware.records.begin(), hardware.records.end());
    hold_against_answers(last, "counted");
}

void Contender::study(const Group& group) {
    if (!verified()) return;
    if (!row_.axes.empty()) {
        costs_.reason = work_.reason = "measured for the cell without further axes";
        return;
    }
    costs_ = step_costs(*runner_, group.workload());
    work_ = algorithm_work(row_.algorithm, type_, group);
}

Timing Contender::time(const Group& group, double clock_cost_ns) const {
    return runner_->time(group.workload(), in_contact_, clock_cost_ns);
}

std::vector<FigureRow> Contender::figures(const Group& group, SizeFamily& sizes,
                                          std::span<const Round> rounds) const {
    std::vector<FigureRow> result;
    if (row_.status == "unavailable") return result;
    Subject subject;
    const BuildTimes build = runner_->build_times(build_repetitions);
    subject.table = table_bytes(runner_->ledger(), runner_->stored_bodies()[0]);
    subject.memory = runner_->memory();
    subject.build = build;
    subject.touched = touched_;
    subject.trace = &trace_;
    subject.heap = heap_of_cell(type_, parts_of(row_.algorithm), runner_->stored_bodies()[0],
                                group.workload(), runner_->pair_bytes());
    subject.sizes = sizes.of(type_, parts_of(row_.algorithm));
    subject.checked = checked_;
    subject.counts = counts_;
    subject.rounds = rounds;
    subject.counted = counted_;
    subject.costs = costs_;
    subject.work = work_;
    for (const auto& probe : registered_probes()) {
        for (Figure& figure : probe->figures(subject)) {
            result.push_back({std::string(probe->name()), std::move(figure)});
        }
    }
    return result;
}

}  // namespace edgewise
