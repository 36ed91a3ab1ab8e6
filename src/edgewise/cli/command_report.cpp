// SPDX-License-Identifier: MIT
//
// `edgewise report`: the pages of a store, written anew.
#include <fmt/format.h>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/reports/page/report.hpp"

namespace edgewise::cli {

namespace {

struct ReportArguments {
    std::string store = default_store;
    std::string out;
};

int run_report(const ReportArguments& options, bool json) {
    const std::string out = options.out.empty() ? folder_of(options.store) : options.out;
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
    command->add_option("--out", options.out, "folder for the report; beside the store if not given");
}

}  // namespace edgewise::cli
