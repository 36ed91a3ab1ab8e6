// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/body_cost.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/table_memory_cost.hpp"
#include "edgewise/sweep/prepared_cell.hpp"

namespace edgewise::studies::advise {

namespace {

constexpr std::size_t queries = 2000;
constexpr int rounds = 7;

/// A body's queries and the cell that they are loaded into.
struct Timed {
    std::unique_ptr<sweep::SharedQueries> shared;
    sweep::PreparedCell cell;
};

Timed prepare(const Polyhedron& body, const bench::TableType& type, const std::string& algorithm) {
    sweep::Plan plan;
    plan.queries = queries;
    plan.checked = 0;
    plan.seed = 1;
    Timed timed{std::make_unique<sweep::SharedQueries>(plan, sweep::SceneChoice{"cold"},
                                                       scene::NamedShape{"budget", "given", body, {}}),
                {type, algorithm}};
    if (const std::string error = timed.cell.load(timed.shared->workload()); !error.empty())
        throw std::invalid_argument(error);
    timed.cell.check(*timed.shared);
    return timed;
}

}  // namespace

std::vector<BodyCost> costs_of(std::span<const Polyhedron> bodies, const bench::TableType& type,
                               const std::string& algorithm) {
    std::vector<Timed> timed;
    std::vector<BodyCost> costs(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        timed.push_back(prepare(bodies[i], type, algorithm));
        costs[i].table_bytes = static_cast<double>(timed[i].cell.runner().ledger().total());
        const auto touched = studies::lines_in_tumble(type, algorithm, bodies[i]);
        if (touched)
            costs[i].lines = static_cast<double>(touched->lines) / static_cast<double>(touched->queries);
    }
    const double clock_cost_ns = measure::calibrate();
    for (int round = 0; round < rounds; ++round) {
        sweep::take_turns(bodies.size(), static_cast<std::uint64_t>(round), [&](std::size_t i) {
            const auto ns = timed[i].cell.time(clock_cost_ns).all();
            if (ns && (round == 0 || *ns < costs[i].ns)) costs[i].ns = *ns;
        });
    }
    return costs;
}

}  // namespace edgewise::studies::advise
