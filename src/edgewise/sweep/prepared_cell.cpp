// SPDX-License-Identifier: MIT
#include "edgewise/sweep/prepared_cell.hpp"

#include <algorithm>
#include <numeric>

#include "edgewise/scene/rng.hpp"
#include "edgewise/sweep/verify.hpp"

namespace edgewise::sweep {

PreparedCell::PreparedCell(const bench::TableType& type, const std::string& algorithm,
                           const bench::RunnerOptions& options)
    : type_(&type), options_(options), runner_(type.make_runner(algorithm)) {
    runner_->configure(options);
}

std::string PreparedCell::load(const scene::Workload& workload) {
    workload_ = &workload;
    return runner_->load(workload);
}

void PreparedCell::check(SharedQueries& shared) {
    const std::vector<Distance> answers = runner_->answer();
    counts_ = count_answers(answers,
                            workload_->warm ? bench::cold_starts(*workload_) : std::vector<std::uint8_t>{});
    double sum = 0;
    for (const Distance& answer : answers) {
        if (options_.needs > Needs::nearer) in_contact_.push_back(answer.status != Status::separated);
        distances_.push_back(sum += answer.distance);
    }
    const auto stored = runner_->stored_bodies();
    QueryOptions asked = options_.query;
    asked.verdict_only = asked.verdict_only || type_->verdict_only;
    checked_ = options_.needs == Needs::nearer
                   ? check_nearness(shared, stored, answers, type_->eps, asked,
                                    [&](const scene::Query& query) { return runner_->margin(query); })
                   : check_answers(shared, stored, answers, type_->eps, asked);
    wrong_ = what_is_wrong(shared, checked_, type_->eps);
}

double PreparedCell::mean_steps() const {
    return static_cast<double>(counts_.steps) / static_cast<double>(counts_.queries);
}

double PreparedCell::distances(std::size_t queries) const {
    return queries > 0 ? distances_[queries - 1] : 0;
}

double PreparedCell::ns_per_query(double clock_cost_ns) const {
    const auto first = runner_->time({}, clock_cost_ns).all(),
               second = runner_->time({}, clock_cost_ns).all();
    return std::min(first.value_or(0), second.value_or(0));
}

void take_turns(std::size_t count, std::uint64_t seed, const std::function<void(std::size_t)>& take) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    scene::Rng rng(seed);
    rng.shuffle(order);
    for (const std::size_t i : order) take(i);
}

}  // namespace edgewise::sweep
