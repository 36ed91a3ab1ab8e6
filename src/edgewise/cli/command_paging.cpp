// SPDX-License-Identifier: MIT
//
// `edgewise paging`: major page faults per query under memory limits, measured, next to their prediction.
#include <fmt/format.h>

#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/studies/paging/paging.hpp"

namespace edgewise::cli {

namespace {

struct PagingArguments {
    std::vector<std::string> layouts = {"aos_f64", "lean_f64"};
    std::string algorithm = "vclip";
    BodyChoice body;
    std::size_t bodies = 600, steps = 6;
    double rotation_step = 0.1;
    bool same_order = false;
    std::vector<double> limits = {2, 4, 5, 6, 7, 12, 16, 24, 32, 48, 64, 80, 96};
    std::uint64_t seed = 1;
};

scene::Workload pressure(const PagingArguments& options) {
    const auto parameters =
        scene::complete_parameters("pressure", {{"bodies", static_cast<double>(options.bodies)},
                                                {"rotation_step", options.rotation_step},
                                                {"new_order", options.same_order ? 0 : 1}})
            .or_throw();
    return scene::make_scene("pressure", chosen_shape(options.body).body, parameters, options.seed,
                             options.steps * (options.bodies - 1), {})
        .or_throw();
}

nlohmann::json json_of(const studies::PagingResult& result) {
    const nlohmann::json rows = json_rows(result.rows, [](const studies::PagingRow& row) {
        const bool measured = row.reason.empty();
        const auto value = [&](double number) {
            return measured ? nlohmann::json(number) : nlohmann::json();
        };
        return nlohmann::json{
            {"limit_bytes", row.limit_bytes},
            {"predicted_at_limit", or_null(row.predicted_at_limit.all)},
            {"predicted_at_limit_cold", or_null(row.predicted_at_limit.cold)},
            {"predicted_at_limit_warm", or_null(row.predicted_at_limit.warm)},
            {"table_pages_held", value(static_cast<double>(row.table_pages_held.value_or(0)))},
            {"predicted_at_held", value(row.predicted_at_held)},
            {"faults_per_query", value(row.faults_per_query)},
            {"ns_per_query", value(row.ns_per_query)},
            {"reason", or_null(row.reason)}};
    });
    return {{"table", result.table},
            {"algorithm", result.algorithm},
            {"table_bytes", result.table_bytes},
            {"pages_touched", result.pages_touched},
            {"queries", result.queries},
            {"keeps_recency", result.keeps_recency},
            {"rows", rows},
            {"reason", or_null(result.reason)}};
}

void print(const studies::PagingResult& result) {
    const auto page = static_cast<double>(studies::page_bytes());
    fmt::print("{} {}: tables {:.1f} MiB, pages touched {:.1f} MiB\n", result.table, result.algorithm,
               static_cast<double>(result.table_bytes) / (1 << 20),
               static_cast<double>(result.pages_touched) * page / (1 << 20));
    if (!result.reason.empty()) fmt::print("  not measured: {}\n", result.reason);
    if (!result.keeps_recency)
        fmt::print("  read-ahead could not be turned off as root would: this kernel may evict any page\n");
    if (!result.rows.empty())
        fmt::print("{}",
                   reports::rows_text(
                       json_of(result)["rows"],
                       fmt::format("#limit, MiB = limit_bytes {0} 1|#predicted = predicted_at_limit|"
                                   "#held, MiB = table_pages_held {1} 1|#predicted = predicted_at_held|"
                                   "#faults per query = faults_per_query|#us per query = ns_per_query 1000",
                                   reports::mebibyte, reports::mebibyte / page)));
}

int run_paging(const PagingArguments& options, bool json) {
    const scene::Workload workload = pressure(options);
    std::vector<std::uint64_t> limits;
    for (const double mebibytes : options.limits)
        limits.push_back(static_cast<std::uint64_t>(mebibytes * (1 << 20)));
    nlohmann::json results = nlohmann::json::array();
    const std::atomic<bool>& stop = stop_on_signals();  // a control group is to be removed
    for (const bench::TableType* type : bench::select_table_types(options.layouts)) {
        if (!type->serves(options.algorithm))
            throw std::invalid_argument(fmt::format("{} does not serve {}", type->name, options.algorithm));
        const studies::PagingResult result = studies::measure_paging(
            *type, options.algorithm, workload, [&](std::uint64_t) { return limits; }, stop);
        if (stop) {
            warn("stopped; nothing is kept of this table");
            return exit_check_failed;
        }
        if (json) {
            results.push_back(json_of(result));
        } else {
            print(result);
        }
    }
    if (json) print_json(nlohmann::json({{"paging", results}}));
    return exit_done;
}

}  // namespace

void add_paging(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "paging",
                    "Page faults of many bodies' queries under memory limits, and their prediction; "
                    "turns a disk's read-ahead off while it opens a file",
                    run_paging);
    add_layouts_option(*command, options.layouts);
    add_algorithm_option(*command, options.algorithm);
    add_shape_option(*command, options.body.shape, options.body.as_stored);
    add_count(*command, "--bodies", options.bodies, {2, 100'000, "bodies"},
              "how many bodies; each has a table of its own");
    add_count(*command, "--steps", options.steps, {1, 1000, "steps"}, "steps of the scene in each pass");
    add_number(*command, "--turn,--rotation-step", options.rotation_step, {0, 100, "rad"},
               "rad by which every body turns per step");
    command->add_flag("--same-order", options.same_order,
                      "ask the pairs in the same order every step, instead of in a new one");
    add_number(*command, "--limits", options.limits, {0, 1e6, "MiB"}, "memory limits, MiB; 0: no limit");
    add_seed_option(*command, options.seed);
    add_thrash(*command, context);
}

}  // namespace edgewise::cli
