// SPDX-License-Identifier: MIT
//
// `edgewise merge`: the stores of a campaign's parts as one.
#include <fmt/format.h>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/parts/figures_of_merit.hpp"
#include "edgewise/cli/usage/folders.hpp"
#include "edgewise/store/merge.hpp"

namespace edgewise::cli {

namespace {

struct MergeArguments {
    std::vector<std::string> stores;
    std::string out;
    bool mixed = false, fom = false;
};

nlohmann::json json_of(const store::MergeSummary& summary, const std::string& out) {
    nlohmann::json builds = nlohmann::json::array();
    for (const store::MergedBuild& build : summary.builds)
        builds.push_back({{"id", build.id}, {"git_revision", build.git_revision}, {"cells", build.cells}});
    return {{"stores", summary.stores}, {"cells", summary.cells},     {"twice", summary.twice},
            {"builds", builds},         {"missing", summary.missing}, {"store", out}};
}

void print(const store::MergeSummary& summary, const std::string& out) {
    fmt::print("{} stores: {} cells", summary.stores, summary.cells);
    if (summary.twice > 0) fmt::print(", {} of them in several stores and the same there", summary.twice);
    fmt::print("\n");
    if (summary.builds.size() > 1) {
        for (const store::MergedBuild& build : summary.builds)
            fmt::print("  {} cells of build {} (machine and program) at revision {}\n", build.cells, build.id,
                       build.git_revision);
    }
    fmt::print("store: {}; for the report: edgewise report {}\n", out, out);
}

int run_merge(const MergeArguments& options, bool json) {
    make_folder_of(options.out, "--out");
    const store::MergeSummary summary = store::merge_stores(options.stores, options.out, options.mixed);
    for (const std::string& line : summary.missing) warn(line);
    if (json)
        print_json(json_of(summary, options.out));
    else
        print(summary, options.out);
    if (options.fom) print_figures_of_merit(options.out);
    return summary.missing.empty() ? exit_done : exit_check_failed;
}

}  // namespace

void add_merge(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "merge", "The stores of a campaign's parts as one", run_merge);
    command->add_option("stores", options.stores, "stores of the parts")->required();
    add_output_file(*command, "--out", options.out,
                    "file to write: the merged store, which replaces an earlier one there")
        ->required();
    command->add_flag("--mixed", options.mixed, "take stores of several plans, seeds or revisions together");
    command->add_flag("--fom", options.fom, "print figures of merit too: FOM name = value unit");
}

}  // namespace edgewise::cli
