// SPDX-License-Identifier: MIT
//
// `edgewise export`: figures of a store in long form, breakdowns too, as CSV or JSON. No Parquet: Debian 12
// packages no library that writes it. Or what the store says of its machine, as a record for others. Or the
// costs of data of its cells, in Callgrind's format.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "edgewise/bench/trace/touched_tables.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/traces/trace_file.hpp"
#include "edgewise/reports/records/machine_record.hpp"
#include "edgewise/reports/results/export.hpp"

namespace edgewise::cli {

namespace {

struct ExportArguments {
    std::string store = default_store;
    std::string format = "csv";
    std::string out;
    reports::ExportChoice choice;
    bool machine_record = false;
    std::string modelled;
    std::vector<std::string> machines;  ///< none: those of a lock
};

constexpr const char* callgrind = "callgrind";

std::string record_text(const ExportArguments& options) {
    const reports::ReportData data = reports::read_report(options.store);
    if (options.modelled.empty()) return to_json(reports::measured_record(data));
    return to_json(reports::modelled_record(data, measure::described_machines({options.modelled}).front()));
}

studies::CellChoice choice_of(const reports::ReportCell& cell) {
    return {.table = cell.table,
            .algorithm = cell.algorithm,
            .scene = cell.scene,
            .shape = cell.shape,
            .parameters = nlohmann::json::parse(cell.scene_parameters).get<scene::SceneParameters>(),
            .queries = static_cast<std::size_t>(cell.queries),
            .seed = cell.seed};
}

/// Traces a cell twice: the second pass is the steady state.
void add_cell(const reports::ReportCell& stored, measure::DataProfile& profile) {
    const studies::SingleCell cell(choice_of(stored));
    const bench::ComponentPlaces places(cell.runner().memory_maps());
    profile.start_object(
        fmt::format("{} {} {} {}", stored.table, stored.algorithm, stored.scene_label, stored.shape),
        [&](const measure::TracedAccess& access) -> std::string_view {
            if (access.side == measure::TraceSide::scene)
                return access.field == bench::pair_cache_field ? "pair" : "broad_phase";
            return places.at(access.address).value_or("object");
        });
    cell.runner().trace(bench::TraceExtent::everything(), profile);
    profile.start_steady();
    cell.runner().trace(bench::TraceExtent::everything(), profile);
}

/// A store has no costs by component, step and field together, so the cells are traced again. Next to the
/// file, in FILE.fields, is a text for each component, which names the fields: what annotations show.
std::string callgrind_text(const ExportArguments& options) {
    const std::vector<std::string> usual = {"pentium3_coppermine", "zen5"};
    const auto machines = measure::described_machines(options.machines.empty() ? usual : options.machines);
    measure::DataProfile profile(machines);
    const reports::ReportData data = reports::read_report(options.store);
    // Plain cells of built-in scenes and bodies can be made again from what the store says.
    for (const reports::ReportCell* cell : reports::chosen_cells(data, options.choice))
        if (cell->run == store::sweep_run && cell->verified() && cell->axes.empty() &&
            cell->scene_kind.empty() && cell->shape_source == "built-in")
            add_cell(*cell, profile);
    if (profile.is_empty())
        throw std::runtime_error("no chosen cell is a verified plain one of a built-in scene and body");
    if (options.out.empty() || !input::output_place(options.out).is_replaced)
        return profile.text(bench::step_names());
    const std::string folder = options.out + ".fields",
                      fields = fmt::format("{}\n", fmt::join(bench::field_names(), "\n"));
    std::filesystem::create_directories(folder);
    for (const std::string_view component : component_names)
        input::write_output(fmt::format("{}/{}", folder, component), fields);
    for (const char* other : {"object", "pair", "broad_phase"})
        input::write_output(folder + "/" + other, fields);
    return profile.text(bench::step_names());
}

int run_export(const ExportArguments& options, bool json) {
    reports::ExportChoice choice = options.choice;
    if (json || options.format == "json") choice.format = reports::ExportFormat::json;
    if (!options.machines.empty() && options.format != callgrind)
        throw std::invalid_argument("--machines is of --format callgrind: give both");
    if (!choice.figures.empty() && options.format == callgrind)
        throw std::invalid_argument("--format callgrind has all costs of data: leave --figures out");
    const std::string text = options.machine_record ? record_text(options)
                             : options.format == callgrind
                                 ? callgrind_text(options)
                                 : reports::export_text(reports::read_report(options.store), choice);
    if (options.out.empty())
        fmt::print("{}", text);
    else
        input::write_output(options.out, text);
    return exit_done;
}

}  // namespace

void add_export(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "export",
                    "Figures of a store, breakdowns too, as CSV or JSON; or costs of data", run_export);
    add_read_store_option(*command, options.store);
    add_names(*command, "--figures", options.choice.figures,
              "patterns such as 'time.*' or 'caches.*.step.*'; the main figures if not given");
    add_names(*command, "--scenes", options.choice.scenes, "only these scenes");
    add_layouts_option(*command, options.choice.layouts);
    command->add_option("--format", options.format, "the format of what is printed")
        ->check(CLI::IsMember({"csv", "json", callgrind}))
        ->capture_default_str();
    CLI::Option* record =
        command->add_flag("--machine-record", options.machine_record,
                          "what the store says of its machine, without names and paths, as JSON");
    add_machines_option(*command, options.machines);
    for (const char* of_figures : {"--figures", "--scenes", "--layouts", "--format", "--machines"})
        record->excludes(command->get_option(of_figures));
    command->get_option("--format")->excludes(command->get_option("--json"));
    command->add_option("--modelled", options.modelled, "of this machine, whose caches the sweep modelled")
        ->needs(record);
    add_output_file(*command, "--out", options.out, "file to write: the figures; stdout if not given");
}

}  // namespace edgewise::cli
