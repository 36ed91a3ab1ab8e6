// SPDX-License-Identifier: MIT
#include "edgewise/studies/single_cell.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "edgewise/scene/shapes.hpp"

namespace edgewise::studies {

namespace {

const bench::TableType& table_type(const std::string& name) {
    const std::string names[] = {name};
    const auto found = bench::select_table_types(names);
    if (found.size() > 1)
        throw std::invalid_argument(
            fmt::format("'{}' names several table types; name one, such as '{}'", name, found.front()->name));
    return *found.front();
}

std::unique_ptr<sweep::SharedQueries> shared_queries(const CellChoice& choice) {
    const scene::NamedShape shape{choice.shape, "built-in", scene::make_shape(choice.shape).or_throw(), {}};
    sweep::Plan plan;
    plan.queries = choice.queries;
    plan.seed = choice.seed;
    return std::make_unique<sweep::SharedQueries>(plan, sweep::SceneChoice{choice.scene, choice.parameters},
                                                  shape);
}

}  // namespace

SingleCell::SingleCell(const CellChoice& choice, const bench::TableOptions& placing)
    : type_(&table_type(choice.table)), shared_(shared_queries(choice)) {
    const std::string names[] = {choice.algorithm};
    const std::string algorithm = bench::select_algorithms(names).front();
    if (!type_->serves(algorithm))
        throw std::invalid_argument(fmt::format("{} does not serve {}", type_->name, algorithm));
    runner_ = type_->make_runner(algorithm);
    if (choice.margin && choice.needs != Needs::nearer)
        throw std::invalid_argument("a margin is of needs nearer: give both");
    runner_->configure(
        {.needs = choice.needs, .tables = placing, .margin = choice.margin.value_or(bench::usual_margin)});
    if (const std::string error = runner_->load(workload()); !error.empty())
        throw std::invalid_argument(error);
}

}  // namespace edgewise::studies
