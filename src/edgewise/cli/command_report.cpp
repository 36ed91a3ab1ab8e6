// SPDX-License-Identifier: MIT
//
// `edgewise report`: the pages of a store, written anew.
#include <fmt/format.h>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/usage/folders.hpp"
#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/page/report.hpp"

namespace edgewise::cli {

namespace {

struct ReportArguments {
    std::string store = default_store;
    std::string out, compare;
    bool explain = false, gate = false;
    double slack = 0.05;
};

/// The folder that the report is written to, which is there then.
std::string out_of(const ReportArguments& options) {
    if (!options.out.empty() && std::filesystem::exists(options.store)) make_folder(options.out, "--out");
    return options.out.empty() ? folder_of(options.store) : options.out;
}

/// What changed from the other store to this one, here and in the pages.
int run_compare(const ReportArguments& options, bool json) {
    const reports::ReportData data = reports::read_report(options.store);
    const reports::Comparison comparison = reports::compare(reports::read_report(options.compare), data);
    if (comparison.paired == 0)
        throw std::invalid_argument(fmt::format("{} and {} have no cell in common: nothing to compare",
                                                options.store, options.compare));
    const reports::ReportSummary summary = reports::write_report(
        data, out_of(options), bench::charts_folder(),
        reports::ReportBeside{&comparison, options.slack,
                              std::filesystem::path(options.compare).filename().string()});
    if (!summary.note.empty()) warn(summary.note);
    if (json) {
        nlohmann::json line = reports::comparison_json(comparison, options.slack);
        line["report"] = summary.page;
        fmt::print("{}\n", line.dump());
    } else {
        fmt::print("{}report: {}\n", reports::comparison_text(comparison, options.slack, options.explain),
                   summary.page);
    }
    return options.gate && comparison.regressions(options.slack) > 0 ? exit_check_failed : exit_done;
}

int run_report(const ReportArguments& options, bool json) {
    if (!options.compare.empty()) return run_compare(options, json);
    const reports::ReportSummary summary =
        reports::write_report(options.store, out_of(options), bench::charts_folder());
    if (!summary.note.empty()) warn(summary.note);
    if (json) {
        const nlohmann::json line = {{"cells", summary.cells},   {"verified", summary.verified},
                                     {"failed", summary.failed}, {"unavailable", summary.unavailable},
                                     {"store", options.store},   {"report", summary.page}};
        fmt::print("{}\n", line.dump());
    } else {
        fmt::print("report: {}\n", summary.page);
    }
    return exit_done;
}

}  // namespace

void add_report(CLI::App& app, Context& context) {
    auto [command, options] = add_command(app, context, "report", "Writes the report of a store", run_report);
    command->add_option("store", options.store, "store of a sweep")->capture_default_str();
    command->add_option("--out", options.out, "folder for the report; beside the store if not given");
    CLI::Option* const compare = command->add_option(
        "--compare", options.compare,
        "what changed since this other store, regressions first: printed, and a chapter of the report");
    command
        ->add_flag("--explain", options.explain, "what each change is made of, and which causes are excluded")
        ->needs(compare);
    command->add_flag("--gate", options.gate, "exit code 1 where something became worse")->needs(compare);
    add_number(*command, "--slack", options.slack, {0, 10}, "a time may become longer by this part of itself")
        ->needs(compare);
}

}  // namespace edgewise::cli
