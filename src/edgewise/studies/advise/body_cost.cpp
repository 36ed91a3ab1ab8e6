// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/body_cost.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/table_memory_cost.hpp"
#include "edgewise/sweep/shared_queries.hpp"

namespace edgewise::studies::advise {

namespace {

constexpr std::size_t queries = 2000;
constexpr int rounds = 7;

/// A body's queries and the runner that they are loaded into.
struct Timed {
    std::unique_ptr<sweep::SharedQueries> shared;
    std::unique_ptr<bench::Runner> runner;
    std::vector<std::uint8_t> in_contact;
};

Timed prepare(const Polyhedron& body, const bench::TableType& type, const std::string& algorithm) {
    sweep::Plan plan;
    plan.queries = queries;
    plan.seed = 1;
    Timed timed;
    timed.shared = std::make_unique<sweep::SharedQueries>(plan, sweep::SceneChoice{"cold"},
                                                          scene::NamedShape{"budget", "given", body, {}});
    timed.runner = type.make_runner(algorithm);
    if (const std::string error = timed.runner->load(timed.shared->workload()); !error.empty())
        throw std::invalid_argument(error);
    for (const Distance& answer : timed.runner->answer())
        timed.in_contact.push_back(answer.status != Status::separated);
    return timed;
}

}  // namespace

std::vector<BodyCost> costs_of(std::span<const Polyhedron> bodies, const bench::TableType& type,
                               const std::string& algorithm) {
    std::vector<Timed> timed;
    std::vector<BodyCost> costs(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        timed.push_back(prepare(bodies[i], type, algorithm));
        costs[i].table_bytes = static_cast<double>(timed[i].runner->ledger().total());
        const auto touched = studies::lines_in_tumble(type, algorithm, bodies[i]);
        if (touched)
            costs[i].lines = static_cast<double>(touched->lines) / static_cast<double>(touched->queries);
    }
    const double clock_cost_ns = measure::calibrate();
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const auto ns = timed[i].runner->time(timed[i].in_contact, clock_cost_ns).all();
            if (ns && (round == 0 || *ns < costs[i].ns)) costs[i].ns = *ns;
        }
    }
    return costs;
}

}  // namespace edgewise::studies::advise
