// SPDX-License-Identifier: MIT
//
// `edgewise export`: figures of a store in long form, breakdowns too, as CSV or JSON. No Parquet: Debian 12
// packages no library that writes it. Or what the store says of its machine, as a record for others.
#include <fmt/format.h>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/usage/folders.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
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
};

std::string record_text(const ExportArguments& options) {
    const reports::ReportData data = reports::read_report(options.store);
    if (options.modelled.empty()) return to_json(reports::measured_record(data));
    return to_json(reports::modelled_record(data, measure::described_machines({options.modelled}).front()));
}

int run_export(const ExportArguments& options, bool json) {
    reports::ExportChoice choice = options.choice;
    if (json || options.format == "json") choice.format = reports::ExportFormat::json;
    const std::string text = options.machine_record
                                 ? record_text(options)
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
        add_command(app, context, "export", "Figures of a store, breakdowns too, as CSV or JSON", run_export);
    add_read_store_option(*command, options.store);
    add_names(*command, "--figures", options.choice.figures,
              "patterns such as 'time.*' or 'caches.*.step.*'; the main figures if not given");
    add_names(*command, "--scenes", options.choice.scenes, "only these scenes");
    add_layouts_option(*command, options.choice.layouts);
    command->add_option("--format", options.format, "the format of what is printed")
        ->check(CLI::IsMember({"csv", "json"}))
        ->capture_default_str();
    CLI::Option* record =
        command->add_flag("--machine-record", options.machine_record,
                          "what the store says of its machine, without names and paths, as JSON");
    command->add_option("--modelled", options.modelled, "of this machine, whose caches the sweep modelled")
        ->needs(record);
    add_output_file(*command, "--out", options.out, "file to write: the figures; stdout if not given");
}

}  // namespace edgewise::cli
