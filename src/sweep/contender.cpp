// SPDX-License-Identifier: MIT
#include "edgewise/sweep/contender.hpp"

#include "edgewise/sweep/verify.hpp"

namespace edgewise {

namespace {

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
    row_.axes = axes.text();
    row_.algorithm = std::move(algorithm);
    row_.layout = type.layout;
    row_.precision = type.precision;
    row_.table = type.name;
}

void Contender::verify(Group& group) {
    if (const std::string error = runner_->load(group.workload().bodies); !error.empty()) {
        make_unavailable(error);
        return;
    }
    const std::vector<Distance> answers = runner_->answer(group.workload());
    counts_ = count_answers(answers);
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
    subject.table = table_bytes(runner_->ledger(0), runner_->stored_bodies()[0]);
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
