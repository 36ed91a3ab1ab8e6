// SPDX-License-Identifier: MIT
#include "edgewise/studies/single_cell.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::studies {

namespace {

const bench::TableType& type_of(const CellChoice& choice) {
    const bool is_peer = !choice.peer.empty();
    const std::string names[] = {is_peer ? choice.peer : choice.table};
    const auto found = is_peer ? bench::select_peer_types(names) : bench::select_table_types(names);
    if (found.size() > 1)
        throw std::invalid_argument(fmt::format("'{}' names several {}; name one, such as '{}'", names[0],
                                                is_peer ? "peers" : "table types", found.front()->name));
    return *found.front();
}

/// Returns the algorithm; a peer has only one, with its own name.
std::string algorithm_of(const CellChoice& choice, const bench::TableType& type) {
    const std::string names[] = {choice.algorithm};
    std::string algorithm = type.is_peer ? type.algorithms.front() : bench::select_algorithms(names).front();
    if (!type.serves(algorithm))
        throw std::invalid_argument(fmt::format("{} does not serve {}", type.name, algorithm));
    if (choice.margin && !has_margin(choice.needs))
        throw std::invalid_argument("a margin goes with needs nearer or within: give both");
    if (type.is_peer && choice.needs != Needs::witnesses)
        throw std::invalid_argument(fmt::format("{} answers with witnesses: leave needs out", type.name));
    return algorithm;
}

bench::RunnerOptions options_of(const CellChoice& choice, const bench::TableOptions& placing) {
    bench::RunnerOptions options{.tables = placing, .margin = choice.margin.value_or(bench::usual_margin)};
    options.query.sub_distance = choice.sub_distance;
    options.set_needs(choice.needs);
    return options;
}

scene::NamedShape shape_of(const CellChoice& choice) {
    const bool is_recorded = scene::names_recording(choice.scene);
    if (is_recorded && choice.shape != CellChoice{}.shape)
        throw std::invalid_argument("a recording has bodies of its own: leave --shape out");
    if (choice.body) return *choice.body;
    if (!is_recorded) scene::refuse_as_stored_without_mesh(choice.as_stored, {&choice.shape, 1});
    auto shape = scene::named_shape(choice.shape, {.as_stored = choice.as_stored});
    if (!shape.warning.empty() && choice.warn) choice.warn(shape.warning);
    return std::move(shape).or_throw();
}

std::unique_ptr<sweep::SharedQueries> shared_queries(const CellChoice& choice) {
    sweep::Plan plan;
    plan.queries = choice.queries;
    plan.seed = choice.seed;
    plan.checked = choice.checked;
    plan.as_stored = choice.as_stored;
    auto shared = std::make_unique<sweep::SharedQueries>(
        plan, sweep::SceneChoice{choice.scene, choice.parameters}, shape_of(choice));
    if (choice.warn && !shared->note().empty()) choice.warn(shared->note());
    return shared;
}

}  // namespace

SingleCell::SingleCell(const CellChoice& choice, const bench::TableOptions& placing)
    : algorithm_(algorithm_of(choice, type_of(choice))),
      shared_(shared_queries(choice)),
      cell_(type_of(choice), algorithm_, options_of(choice, placing)) {
    if (const std::string error = cell_.load(workload()); !error.empty()) throw std::invalid_argument(error);
    if (choice.checked > 0) cell_.check(*shared_);
}

store::CellRow row_of(const CellChoice& choice, const bench::TableType& type, const std::string& run) {
    const scene::NamedShape shape = shape_of(choice);
    store::CellRow row;
    row.run = run;
    row.scene = choice.scene;
    row.scene_parameters =
        bench::parameters_json(scene::complete_parameters(choice.scene, choice.parameters).or_throw());
    sweep::Axes axes;
    if (choice.algorithm == "gjk") axes.query.sub_distance = choice.sub_distance;
    axes.set_needs(choice.needs);
    if (choice.margin) axes.margin = *choice.margin;
    row.axes = axes.text();
    row.shape = shape.name;
    row.shape_source = shape.source;
    row.algorithm = choice.algorithm;
    row.seed = choice.seed;
    row.queries = static_cast<std::int64_t>(choice.queries);
    bench::describe_cell(row, type, shape.body);
    bench::name_cell(row, shape.body);
    return row;
}

std::string contender_name(const std::string& algorithm, const std::string& table) {
    return (algorithm == "vclip" ? "V-Clip" : algorithm == "gjk" ? "GJK" : algorithm) + " on " + table;
}

}  // namespace edgewise::studies
