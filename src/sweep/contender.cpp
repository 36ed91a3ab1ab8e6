// SPDX-License-Identifier: MIT
#include "edgewise/sweep/contender.hpp"

#include "edgewise/sweep/verify.hpp"

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
    counts_ = count_answers(answers);
    touched_ = runner_->lines_touched(workload, traced_queries);
    for (const Distance& answer : answers) in_contact_.push_back(answer.status != Status::separated);
    checked_ = check_answers(group, runner_->stored_bodies(), answers, type_.eps, axes_.query);
    row_.reason = what_is_wrong(group, checked_, type_.eps);
    row_.status = row_.reason.empty() ? "verified" : "failed";
}

Timing Contender::time(const Group& group, double clock_cost_ns) const {
    return runner_->time(group.workload(), in_contact_, clock_cost_ns);
}

std::vector<FigureRow> Contender::figures(SizeFamily& sizes, std::span<const Round> rounds) const {
    std::vector<FigureRow> result;
    if (row_.status == "unavailable") return result;
    Subject subject;
    const BuildTimes build = runner_->build_times(build_repetitions);
    subject.table = table_bytes(runner_->ledger(), runner_->stored_bodies()[0]);
    subject.memory = runner_->memory();
    subject.build = build;
    subject.touched = touched_;
    subject.sizes = sizes.of(type_, parts_of(row_.algorithm));
    subject.checked = checked_;
    subject.counts = counts_;
    subject.rounds = rounds;
    for (const auto& probe : registered_probes()) {
        for (Figure& figure : probe->figures(subject)) {
            result.push_back({std::string(probe->name()), std::move(figure)});
        }
    }
    return result;
}

}  // namespace edgewise
