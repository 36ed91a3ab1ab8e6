// SPDX-License-Identifier: MIT
//
// `edgewise report`: the pages of a store, written anew.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/store_path.hpp"
#include "edgewise/reports/page/report.hpp"

namespace edgewise::cli {

namespace {

struct Options {
    std::string store = default_store;
    std::string out;
};

int run(const Options& options, bool json) {
    const auto beside_store = std::filesystem::path(options.store).parent_path().string();
    const std::string out = !options.out.empty() ? options.out : !beside_store.empty() ? beside_store : ".";
    const reports::ReportSummary summary = reports::write_report(options.store, out, bench::charts_folder());
    if (!summary.note.empty()) fmt::print(stderr, "edgewise: {}\n", summary.note);
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
    auto options = std::make_shared<Options>();
    CLI::App* command = add_command(app, context, "report", "Writes the report of a store");
    command->add_option("store", options->store, "store of a sweep")->capture_default_str();
    command->add_option("--out", options->out, "folder for the report; beside the store if not given");
    command->callback(
        [options, &context] { context.action = [=, &context] { return run(*options, context.json); }; });
}

}  // namespace edgewise::cli
