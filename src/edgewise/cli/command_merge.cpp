// SPDX-License-Identifier: MIT
//
// `edgewise merge`: the stores of a campaign's parts as one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "edgewise/cli/options.hpp"
#include "edgewise/store/merge.hpp"
#include "edgewise/store/rows.hpp"

namespace edgewise::cli {

namespace {

/// Adds up logarithms.
struct GeometricMean {
    double sum = 0;
    std::size_t count = 0;
};

double total(const store::StoredBuild& stored, const store::FigureName& name) {
    double sum = 0;
    for (const store::StoredCell& cell : stored.cells) sum += cell.figure(name).value.value_or(0);
    return sum;
}

std::size_t cells_that_are(const store::StoredBuild& stored, store::CellStatus status) {
    return static_cast<std::size_t>(std::ranges::count_if(
        stored.cells, [&](const store::StoredCell& cell) { return cell.status == status; }));
}

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

void print_figures_of_merit(const std::string& store) {
    const store::StoredBuild stored = store::read_build(store);
    fmt::print("FOM cells_verified = {} cells\n", cells_that_are(stored, store::CellStatus::verified));
    fmt::print("FOM cells_failed = {} cells\n", cells_that_are(stored, store::CellStatus::failed));
    fmt::print("FOM answers_checked = {:.0f} queries\n",
               total(stored, "error.checked") + total(stored, "stability.cases"));
    fmt::print("FOM answers_wrong = {:.0f} queries\n",
               total(stored, "error.wrong_answers") + total(stored, "stability.wrong_answers"));
    std::map<std::string, GeometricMean> ratios;
    for (const store::StoredCell& cell : stored.cells) {
        const auto ratio = cell.figure("time.all_ratio").value;
        if (!cell.verified() || !cell.axes.empty() || !ratio || !(*ratio > 0)) continue;
        GeometricMean& mean = ratios[cell.algorithm + "." + cell.table];
        mean.sum += std::log(*ratio);
        ++mean.count;
    }
    for (const auto& [name, mean] : ratios)
        fmt::print("FOM time_ratio.{} = {:.4f} 1\n", name,
                   std::exp(mean.sum / static_cast<double>(mean.count)));
}

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
