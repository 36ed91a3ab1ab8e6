// SPDX-License-Identifier: MIT
//
// `edgewise lock`: the deterministic figures of one table type on one scene, to be kept in a file under
// version control, and compared with it later: bytes by component, lines per query, modelled misses.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/parts/chosen_body.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/lock/lock_program.hpp"
#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::cli {

namespace {

struct LockArguments {
    studies::CellChoice cell;
    std::vector<std::string> machines = {"pentium3_coppermine", "zen5"};
    std::string check;
    bool as_stored = false;
};

/// Of a lock whose mesh was read with --as-stored; no other lock has it.
constexpr const char* stored_condition = "as_stored";

/// A built-in body, or all meshes of a file as one hull: names of files have a dot.
scene::NamedShape shape_named(const std::string& name, bool as_stored) {
    if (scene::names_mesh_file(name)) return {name, name, mesh_body(name, as_stored).body, {}};
    if (as_stored) throw std::invalid_argument("--as-stored is of mesh files: name one with --shape");
    return {name, "built-in", scene::make_shape(name).or_throw(), {}};
}

const bench::TableType& type_named(const LockArguments& options) {
    const std::string names[] = {options.cell.table};
    const auto types = bench::select_table_types(names);
    if (types.size() > 1)
        throw std::invalid_argument(fmt::format("'{}' names several table types; name one, such as '{}'",
                                                options.cell.table, types.front()->name));
    if (!types.front()->serves(options.cell.algorithm))
        throw std::invalid_argument(
            fmt::format("{} does not serve {}", options.cell.table, options.cell.algorithm));
    return *types.front();
}

std::vector<measure::ComponentBytes> bytes_of(const bench::Runner& runner) {
    const Ledger ledger = runner.ledger();
    std::vector<measure::ComponentBytes> bytes;
    for (std::size_t i = 0; i < component_names.size(); ++i)
        bytes.push_back({std::string(component_names[i]), ledger.bytes[i]});
    bytes.push_back({"object", runner.object_bytes()});
    bytes.push_back({"pair", runner.pair_bytes()});
    return bytes;
}

/// What must be the same for figures to be comparable; what the bodies have is found out again by a check.
measure::Conditions conditions(const LockArguments& options, const Polyhedron& stored) {
    std::vector<std::string> parameters;
    for (const auto& [name, value] : options.cell.parameters)
        parameters.push_back(fmt::format("{}={}", name, value));
    measure::Conditions of = {{"table", options.cell.table},
                              {"algorithm", options.cell.algorithm},
                              {"shape", options.cell.shape},
                              {"vertices", std::to_string(stored.vertex_count())},
                              {"edges", std::to_string(stored.edge_count())},
                              {"scene", options.cell.scene},
                              {"parameters", fmt::format("{}", fmt::join(parameters, ","))},
                              {"queries", std::to_string(options.cell.queries)},
                              {"seed", std::to_string(options.cell.seed)},
                              {"machines", fmt::format("{}", fmt::join(options.machines, ","))}};
    if (options.as_stored) of.emplace_back(stored_condition, "yes");
    return of;
}

measure::FigureRecord lock_of(const LockArguments& options) {
    const bench::TableType& type = type_named(options);
    const std::vector<measure::CacheMachine> machines = measure::described_machines(options.machines);
    sweep::Plan plan;
    plan.queries = options.cell.queries;
    plan.seed = options.cell.seed;
    const sweep::SharedQueries queries(plan, {options.cell.scene, options.cell.parameters},
                                       shape_named(options.cell.shape, options.as_stored));
    const auto runner = type.make_runner(options.cell.algorithm);
    runner->configure({});
    if (const std::string error = runner->load(queries.workload()); !error.empty())
        throw std::invalid_argument(error);
    const auto pass = [&](measure::TraceListener& listener) {
        static_cast<void>(runner->trace(bench::TraceExtent::everything(), listener));
    };
    const auto fields = bench::field_names();
    measure::LayoutFacts facts = measure::measure_layout(
        pass, machines, std::vector<std::string>(fields.begin(), fields.end()), bench::step_names().size());
    facts.bytes = bytes_of(*runner);
    return measure::lock_of(facts, conditions(options, runner->stored_bodies()[0]));
}

std::uint64_t number_in(const measure::FigureRecord& lock, const char* name, const std::string& file) {
    const std::string& text = lock.condition(name, file);
    const auto value = input::parse_count(text, {});
    if (!value) throw std::runtime_error(fmt::format("{}: of.{}: {}", file, name, value.error));
    return *value;
}

/// The lock's own conditions as options.
LockArguments options_of(const measure::FigureRecord& lock, const std::string& file) {
    LockArguments options;
    options.cell.table = lock.condition("table", file);
    options.cell.algorithm = lock.condition("algorithm", file);
    options.cell.shape = lock.condition("shape", file);
    options.as_stored = std::ranges::find(lock.of, stored_condition,
                                          &std::pair<std::string, std::string>::first) != lock.of.end();
    options.cell.scene = lock.condition("scene", file);
    options.cell.queries = number_in(lock, "queries", file);
    options.cell.seed = number_in(lock, "seed", file);
    for (const std::string& text : CLI::detail::split(lock.condition("parameters", file), ','))
        if (!text.empty()) take_parameter(text, options.cell.parameters);
    options.machines = CLI::detail::split(lock.condition("machines", file), ',');
    return options;
}

int check_lock(const std::string& file, bool json) {
    const measure::FigureRecord was = measure::read_record(file, "lock");
    const measure::RecordComparison found = measure::compare(was, lock_of(options_of(was, file)));
    fmt::print("{}", json ? to_json(found) : input::shown_text(to_text(found, file)));
    return found.exit_code();
}

int run_lock(const LockArguments& options, bool json) {
    if (!options.check.empty()) return check_lock(options.check, json);
    fmt::print("{}", measure::to_json(lock_of(options)));
    return exit_done;
}

}  // namespace

void add_lock(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "lock", "The deterministic figures of a layout, to hold it to", run_lock);
    const std::vector<CLI::Option*> of = {
        command->add_option("--table", options.cell.table, "table type")->capture_default_str(),
        command->add_option("--algorithm", options.cell.algorithm, "vclip or gjk")->capture_default_str(),
        command->add_option("--shape", options.cell.shape, "built-in shape, or a mesh file")
            ->capture_default_str(),
        command->add_option("--scene", options.cell.scene, "scene")->capture_default_str(),
        add_count(*command, "--queries", options.cell.queries, {1, 1'000'000, "queries"}, "queries per pass"),
        add_count(*command, "--seed", options.cell.seed, input::seed_range, "seed of the scene"),
        add_parameter_option(*command, options.cell.parameters),
        command->add_option("--machines", options.machines, "whose caches: names, or your own NAME.json")
            ->delimiter(',')
            ->capture_default_str(),
        add_as_stored_option(*command, options.as_stored)};
    CLI::Option* const check =
        command->add_option("--check", options.check, "compare with this lock, of what it says itself");
    for (CLI::Option* option : of) check->excludes(option);
}

}  // namespace edgewise::cli
