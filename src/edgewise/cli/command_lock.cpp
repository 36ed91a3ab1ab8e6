// SPDX-License-Identifier: MIT
//
// `edgewise lock`: the deterministic figures of one table type on one scene, to be kept in a file under
// version control, and compared with it later: bytes by component, lines per query, modelled misses.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/lock/lock_program.hpp"
#include "edgewise/scene/scene_file.hpp"

namespace edgewise::cli {

namespace {

struct LockArguments {
    studies::CellChoice cell;
    std::vector<std::string> machines = {"pentium3_coppermine", "zen5"};
    std::vector<measure::Limit> limits;
    std::string check, format;
    bool header = false;
};

/// A lock has this condition only if its mesh was read with --as-stored.
constexpr const char* stored_condition = "as_stored";

/// The body; all meshes of a file are one hull in its own size. A recording has bodies of its own.
scene::NamedShape shape_of(const LockArguments& options) {
    if (scene::names_recording(options.cell.scene))
        return scene::read_scene_file(options.cell.scene, {.as_stored = options.cell.as_stored})
            .or_throw()
            .shapes.front();
    const std::string& name = options.cell.shape;
    scene::MeshBody body = chosen_body({name, options.cell.as_stored});
    return {name, scene::names_mesh_file(name) ? name : "built-in", std::move(body.body), {}};
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

/// Conditions that must be equal for figures to be comparable. A check counts the bodies' features again.
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
    if (options.cell.as_stored) of.emplace_back(stored_condition, "yes");
    return of;
}

measure::FigureRecord lock_of(LockArguments options) {
    const std::vector<measure::CacheMachine> machines = measure::described_machines(options.machines);
    studies::CellChoice choice = options.cell;
    choice.body = shape_of(options);
    choice.warn = warn;
    if (scene::names_recording(choice.scene)) options.cell.shape = choice.body->source;
    const studies::SingleCell cell(choice);
    const auto pass = [&](measure::TraceListener& listener) {
        static_cast<void>(cell.runner().trace(bench::TraceExtent::everything(), listener));
    };
    const auto fields = bench::field_names();
    measure::LayoutFacts facts =
        measure::measure_layout(pass, machines, {fields.begin(), fields.end()}, bench::step_names().size());
    facts.bytes = bytes_of(cell.runner());
    measure::FigureRecord lock =
        measure::lock_of(facts, conditions(options, cell.runner().stored_bodies()[0]));
    lock.limits = options.limits;
    return lock;
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
    options.cell.as_stored = std::ranges::find(lock.of, stored_condition,
                                               &std::pair<std::string, std::string>::first) != lock.of.end();
    options.cell.scene = lock.condition("scene", file);
    const std::string& shape = lock.condition("shape", file);
    if (!scene::names_recording(options.cell.scene)) options.cell.shape = shape;
    options.cell.queries = number_in(lock, "queries", file);
    options.cell.seed = number_in(lock, "seed", file);
    for (const std::string& text : CLI::detail::split(lock.condition("parameters", file), ','))
        if (!text.empty()) take_parameter(text, options.cell.parameters);
    options.machines = CLI::detail::split(lock.condition("machines", file), ',');
    return options;
}

/// The lock's sizes as a header for a user's build, of which each fails to compile if it differs there.
std::string header_of(const LockArguments& options, const measure::FigureRecord& lock) {
    const bench::TableType& type = bench::table_type_called(options.cell.table);
    const auto bytes_of = [&](const std::string& component) {
        return std::ranges::find(lock.rows, "bytes" + component, &measure::RecordRow::figure)->value;
    };
    const double object = bytes_of(".object"), pair = bytes_of(".pair");
    std::string file = type.layout;  // a layout with a number of several digits lies in the file without it
    if (const std::size_t end = file.find_last_not_of("0123456789") + 1; file.size() - end > 1)
        file.resize(end);
    return fmt::format(
        R"(// Generated by edgewise lock --header: {table} with {algorithm}, {shape}. Include it in one source file.
#pragma once

#include <cstddef>
#include <edgewise/algorithms/{algorithm}.hpp>
#include <{layouts}/{file}.hpp>

namespace edgewise_lock::{table} {{
using Table = edgewise::{layout}<edgewise::{precision}>;
using Pair = edgewise::{type}::Pair<Table, Table>;
/// Bytes of one body of {vertices} vertices and {edges} edges: its object, and the memory of its table.
inline constexpr std::size_t body_bytes = sizeof(Table) + {memory};
static_assert(sizeof(Table) == {object}, "the table's object is no longer {object} bytes");
static_assert(sizeof(Pair) == {pair}, "a pair's memory is no longer {pair} bytes");
static_assert(body_bytes == {body}, "a body no longer takes {body} bytes");
}}  // namespace edgewise_lock::{table}
)",
        fmt::arg("table", type.name), fmt::arg("algorithm", options.cell.algorithm),
        fmt::arg("shape", lock.condition("shape", "")), fmt::arg("layouts", "edgewise/layouts"),
        fmt::arg("file", file), fmt::arg("layout", type.layout), fmt::arg("precision", type.precision),
        fmt::arg("type", options.cell.algorithm == "gjk" ? "Gjk" : "VClip"),
        fmt::arg("vertices", lock.condition("vertices", "")), fmt::arg("edges", lock.condition("edges", "")),
        fmt::arg("memory", bytes_of("") - object - pair), fmt::arg("object", object), fmt::arg("pair", pair),
        fmt::arg("body", bytes_of("") - pair));
}

/// Adds "misses_per_query.*=5%", a soft limit, or "bytes=12000", a hard one.
void take_limit(std::string text, std::vector<measure::Limit>& limits) {
    const bool soft = text.ends_with('%');
    if (soft) text.pop_back();
    scene::SceneParameters given;
    take_parameter(text, given, "--limit");
    const auto& [figures, number] = *given.begin();
    for (const measure::Limit& known : limits)
        if (known.figures == figures && (soft ? known.soft : known.hard))
            throw CLI::ValidationError(fmt::format("--limit {}: given twice: leave one out", figures));
    measure::Limit& limit = limits.emplace_back();
    limit.figures = figures;
    (soft ? limit.soft : limit.hard) = soft ? number / 100 : number;
}

int check_lock(const LockArguments& options, bool json) {
    const measure::FigureRecord was = measure::read_record(options.check, "lock");
    return print_comparison(measure::compare(was, lock_of(options_of(was, options.check))), options.check,
                            json, options.format);
}

int run_lock(const LockArguments& options, bool json) {
    if (!options.check.empty()) return check_lock(options, json);
    const measure::FigureRecord lock = lock_of(options);
    const std::string text = measure::to_json(lock);
    static_cast<void>(measure::parse_record(text, "--limit"));  // refuses a limit of no figure
    fmt::print("{}", options.header ? header_of(options, lock) : text);
    return exit_done;
}

}  // namespace

void add_lock(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "lock", "The deterministic figures of a layout, to hold it to", run_lock);
    std::vector<CLI::Option*> of = {
        add_table_option(*command, options.cell.table),
        add_algorithm_option(*command, options.cell.algorithm),
        add_shape_option(*command, options.cell.shape, options.cell.as_stored),
        add_scene_option(*command, options.cell.scene),
        add_queries_option(*command, options.cell.queries, {1, 1'000'000, "queries"}),
        add_seed_option(*command, options.cell.seed),
        add_parameter_option(*command, options.cell.parameters),
        add_machines_option(*command, options.machines),
        command->get_option("--as-stored"),
        command
            ->add_option_function<std::vector<std::string>>(
                "--limit",
                [&limits = options.limits](const std::vector<std::string>& texts) {
                    for (const std::string& text : texts) take_limit(text, limits);
                },
                "how far figures may go: by 5% (else they are worse), or to 12000 (else exit code 3)")
            ->type_name("FIGURE=LIMIT")};
    of.push_back(command
                     ->add_flag("--header", options.header,
                                "print sizes and bytes per body as a C++ header of static_asserts instead")
                     ->excludes(of.back())
                     ->excludes(command->get_option("--json")));
    CLI::Option* const check =
        command->add_option("--check", options.check, "compare with this lock, of what it says itself");
    for (CLI::Option* option : of) check->excludes(option);
    add_format_option(*command, options.format);
    command->get_option("--format")->needs(check);
}

}  // namespace edgewise::cli
