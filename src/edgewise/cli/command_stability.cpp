// SPDX-License-Identifier: MIT
//
// `edgewise stability`: the hard families through every algorithm and table type, judged exactly, into the
// store.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/cli/usage/folders.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::cli {

namespace {

struct StabilityArguments {
    std::string store = default_store;
    std::vector<std::string> families, layouts = {"all"}, algorithms = {"all"}, meshes;
    std::size_t count = 200, proofs = 200;
    std::uint64_t seed = 1;
};

/// Hulls of these mesh files, or of the usual ones, of which those that cannot be read are passed over.
std::vector<Polyhedron> real_bodies(const std::vector<std::string>& meshes) {
    sweep::Plan plan = sweep::make_plan("quick");
    plan.shapes.clear();
    if (!meshes.empty()) {
        plan.meshes = meshes;
        plan.meshes_required = true;
    }
    std::vector<Polyhedron> bodies;
    for (scene::NamedShape& shape : sweep::shapes_of(plan, warn)) {
        if (shape.error.empty()) bodies.push_back(std::move(shape.body));
    }
    return bodies;
}

studies::StabilityPlan chosen_plan(const StabilityArguments& options) {
    studies::StabilityPlan plan;
    plan.families = options.families;
    plan.count = options.count;
    plan.proofs = options.proofs;
    plan.seed = options.seed;
    plan.types = bench::select_table_types(options.layouts);
    plan.algorithms = bench::select_algorithms(options.algorithms);
    plan.real = real_bodies(options.meshes);
    return plan;
}

double value_of(const studies::StabilityRow& row, const store::FigureName& name) {
    for (const store::FigureRow& figure : row.figures) {
        if (figure.name == name.name()) return figure.value.value_or(0);
    }
    return 0;
}

void print_heading() {
    fmt::print(
        "{:<24} {:<9} {:<6} {:>8} {:>7} {:>6} {:>6} {:>6} {:>8} {:>8} {:>8} {:>4} {:>7} {:>7} {:>7} {:>6} "
        "{:>5}\n",
        "family", "table", "by", "cases", "refused", "band", "wrong", "beyond", "error", "witness", "cert.",
        "caps", "escapes", "cycles", "fallb.", "refin.", "steps");
}

void print_row(const studies::StabilityRow& row) {
    const auto count = [&](const store::FigureName& name) {
        return static_cast<std::size_t>(value_of(row, name));
    };
    fmt::print(
        "{:<24} {:<9} {:<6} {:>8} {:>7} {:>6} {:>6} {:>6} {:>8.1e} {:>8.1e} {:>8.1e} {:>4} {:>7} {:>7} {:>7} "
        "{:>6} "
        "{:>5.2f}{}\n",
        row.cell.shape, row.cell.table, row.cell.algorithm, count("stability.cases"),
        count("stability.refused"), count("stability.in_band"), count("stability.wrong_outside_band"),
        count("stability.errors_beyond"), value_of(row, "stability.worst_error"),
        value_of(row, "stability.worst_witness_error"), value_of(row, "stability.worst_certificate_width"),
        count("stability.cap_hits"), count("stability.escapes"), count("stability.cycles"),
        count("stability.fallbacks"), count("stability.refinements"), value_of(row, "stability.mean_steps"),
        row.cell.reason.empty() ? "" : "  " + row.cell.status + ": " + row.cell.reason);
}

int run_stability(const StabilityArguments& options, bool json) {
    check_folder_of_store(options.store);
    const studies::StabilityPlan plan = chosen_plan(options);
    static_cast<void>(studies::stability_rows(plan));  // refuses unknown families before a store is made
    make_folder_of_store(options.store);
    store::Store store(options.store);
    if (!json) print_heading();
    Progress progress("stability", studies::stability_rows(plan), 0, "rows");
    const studies::StabilitySummary summary =
        store_stability(plan, store, [&](const studies::StabilityRow& row) {
            if (!json) {
                progress.clear();
                print_row(row);
            }
            progress.advance(1, row.cell.shape + " " + row.cell.table);
        });
    progress.clear();
    if (json) {
        const nlohmann::json line = {{"rows", summary.rows},
                                     {"verified", summary.rows - summary.failed - summary.unavailable},
                                     {"failed", summary.failed},
                                     {"unavailable", summary.unavailable},
                                     {"store", options.store}};
        fmt::print("{}\n", line.dump());
    } else {
        fmt::print(
            "{} rows: {} verified, {} failed, {} unavailable\nstore: {}; for the report: edgewise report {}\n",
            summary.rows, summary.rows - summary.failed - summary.unavailable, summary.failed,
            summary.unavailable, options.store, options.store);
    }
    return summary.failed > 0 || summary.stopped ? exit_check_failed : exit_done;
}

}  // namespace

void add_stability(CLI::App& app, Context& context) {
    const CLI::Range at_least_one(1, 1'000'000'000);
    auto [command, options] =
        add_command(app, context, "stability",
                    "Hard cases through every algorithm and table type, judged exactly", run_stability);
    add_names(*command, "--families", options.families, "only these families (edgewise list families)");
    add_names(*command, "--layouts", options.layouts, "only these layouts or table types");
    add_names(*command, "--algorithms", options.algorithms, "only these algorithms");
    command->add_option("--mesh", options.meshes, "mesh files for the family of real hulls");
    command->add_option("--count", options.count, "poses per family")
        ->check(at_least_one)
        ->capture_default_str();
    command
        ->add_option("--proofs", options.proofs, "poses per family with depth, certificate and time, at most")
        ->capture_default_str();
    command->add_option("--seed", options.seed, "seed of the generators")->capture_default_str();
    command->add_option("--store", options.store, "SQLite file to write into")->capture_default_str();
}

}  // namespace edgewise::cli
