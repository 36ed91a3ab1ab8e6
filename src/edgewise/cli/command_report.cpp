// SPDX-License-Identifier: MIT
//
// `edgewise report`: the pages of a store, written anew.
#include <fmt/format.h>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
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

/// What changed from the other store to this one; no page is written.
int run_compare(const ReportArguments& options, bool json) {
    const reports::Comparison comparison =
        reports::compare(reports::read_report(options.compare), reports::read_report(options.store));
    if (comparison.paired == 0)
        throw std::invalid_argument(fmt::format("{} and {} have no cell in common: nothing to compare",
                                                options.store, options.compare));
    fmt::print("{}", json ? reports::comparison_json(comparison, options.slack).dump() + "\n"
                          : reports::comparison_text(comparison, options.slack, options.explain));
    return options.gate && comparison.regressions(options.slack) > 0 ? exit_check_failed : exit_done;
}

int run_report(const ReportArguments& options, bool json) {
    if (!options.compare.empty()) return run_compare(options, json);
    const std::string out = options.out.empty() ? folder_of(options.store) : options.out;
    if (!options.out.empty() && std::filesystem::exists(options.store)) make_folder(options.out, "--out");
    const reports::ReportSummary summary = reports::write_report(options.store, out, bench::charts_folder());
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
    CLI::Option* const out =
        command->add_option("--out", options.out, "folder for the report; beside the store if not given");
    CLI::Option* const compare =
        command
            ->add_option("--compare", options.compare,
                         "instead of pages: what changed since this other store, regressions first")
            ->excludes(out);
    command
        ->add_flag("--explain", options.explain, "what each change is made of, and which causes are excluded")
        ->needs(compare);
    command->add_flag("--gate", options.gate, "exit code 1 where something became worse")->needs(compare);
    command->add_option("--slack", options.slack, "a time may become longer by this part of itself")
        ->needs(compare)
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
}

}  // namespace edgewise::cli
