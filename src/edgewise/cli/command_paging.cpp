// SPDX-License-Identifier: MIT
//
// `edgewise paging`: major page faults per query under memory limits, measured, next to their prediction.
// And `paging thrash`: which mechanisms, memories and costs of a fault could have made the paper's figure 8,
// and three of them made real.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/studies/paging/paging.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"

namespace edgewise::studies::thrash {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FactScore, rise, top_ns, gjk_rise, gjk_rise_from_8, fall, gjk_fall)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RealisedPoint, speed, queries, in_memory_ns, predicted_faults, faults,
                                   soft_faults, predicted_ns, measured_ns, model_ns, same_answers)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RealisedCurve, shape, algorithm, points)

}  // namespace edgewise::studies::thrash

namespace edgewise::cli {

namespace {

namespace thrash = studies::thrash;

struct ThrashArguments {
    thrash::Levels levels;
    std::size_t realised = thrash::realised_cells;
    double wait_s = thrash::budget_of_a_point_ns / 1e9;
};

nlohmann::json json_of(const thrash::Setting& setting, const thrash::Factorial& factorial) {
    return {{"mechanism", thrash::mechanism_names[static_cast<std::size_t>(setting.mechanism)]},
            {"intensity", setting.intensity},
            {"table", setting.table},
            {"own_tables", !setting.shared},
            {"time_step", setting.time_step},
            {"bodies", setting.bodies},
            {"memory_bytes", setting.memory_bytes},
            {"fault_ns", setting.fault_ns},
            {"machine", factorial.machines[setting.machine].name()}};
}

nlohmann::json json_of(const thrash::Outcome& outcome, const thrash::Factorial& factorial) {
    nlohmann::json json = outcome.score;
    for (std::size_t i = 0; i < thrash::fact_names.size(); ++i)
        json["facts"][std::string(thrash::fact_names[i])] = outcome.score.holds[i];
    const thrash::Figure8& figure = outcome.figure;
    json.update({{"setting", json_of(outcome.setting, factorial)},
                 {"facts_held", outcome.score.count()},
                 {"vclip_38_ns", figure.vclip_38},
                 {"vclip_386_ns", figure.vclip_386},
                 {"gjk_38_ns", figure.gjk_38},
                 {"gjk_386_ns", figure.gjk_386}});
    return json;
}

nlohmann::json json_of(const thrash::RealisedCell& cell, const thrash::Factorial& factorial) {
    const bool there = cell.reason.empty();
    return {{"setting", json_of(cell.setting, factorial)},
            {"curves", there ? nlohmann::json(cell.curves) : nlohmann::json()},
            {"worst_ratio", there ? nlohmann::json(cell.worst_ratio()) : nlohmann::json()},
            {"reason", or_null(cell.reason)},
            {"remedy", or_null(cell.remedy)}};
}

nlohmann::json json_of(const thrash::Calibration& calibration, const thrash::Factorial& factorial) {
    nlohmann::json points;
    for (const thrash::CalibrationPoint& point : calibration.points)
        points[fmt::format("figure_{}", point.figure)] =
            point.model_ns(calibration.ns_per_read) / point.top_ns;
    return {{"machine", factorial.machines[calibration.machine].name()},
            {"time_step", calibration.time_step},
            {"ns_per_read", calibration.ns_per_read},
            {"model_over_paper", points}};
}

nlohmann::json json_of(const thrash::OutcomeGroup& group, const thrash::Factorial& factorial) {
    nlohmann::json with;
    for (std::size_t i = 0; i < thrash::fact_names.size(); ++i)
        with[std::string(thrash::fact_names[i])] = group.with(static_cast<thrash::Fact>(i));
    return {{"of", json_of(group.setting, factorial)},
            {"settings", group.outcomes.size()},
            {"with", with},
            {"with_all", group.with_all()},
            {"best", json_of(group.best(), factorial)}};
}

nlohmann::json json_of(const thrash::Factorial& factorial, const std::vector<thrash::RealisedCell>& cells) {
    const auto json = [&](const auto& of) { return json_of(of, factorial); };
    std::vector<thrash::Outcome> region;
    std::ranges::copy_if(factorial.outcomes, std::back_inserter(region),
                         [](const thrash::Outcome& outcome) { return outcome.score.count() == 4; });
    return {{"calibrations", json_rows(factorial.calibrations, json)},
            {"groups", json_rows(groups_of(factorial), json)},
            {"region", json_rows(region, json)},
            {"realised", json_rows(cells, json)},
            {"cycles", factorial.cycles},
            {"vclip_queries", factorial.vclip_queries}};
}

void print(const nlohmann::json& result, const thrash::Factorial& factorial) {
    std::string calibrated = "machine|#step, s = time_step|#ns per read = ns_per_read";
    for (const auto& [figure, ratio] : result["calibrations"].front()["model_over_paper"].items())
        calibrated += fmt::format("|#model / paper, {0} = model_over_paper/{0}", figure);
    nlohmann::json groups = result["groups"];
    std::erase_if(groups.get_ref<nlohmann::json::array_t&>(), [&](const nlohmann::json& group) {
        return group["of"]["machine"] != factorial.machines.front().name();
    });
    fmt::print("{}\n{}best: facts that hold, bodies, MiB, us a fault; rise, top in us, GJK's rise, fall\n",
               reports::rows_text(result["calibrations"], calibrated),
               reports::rows_text(
                   groups,
                   "mechanism = of/mechanism|#intensity = of/intensity|table = of/table|"
                   "own = of/own_tables|#step, s = of/time_step|#settings|#rises = with/rises|"
                   "#as long = with/takes_as_long|#spares GJK = with/spares_gjk|#erratic = with/erratic|"
                   "#all = with_all|#best = best/facts_held|#bodies = best/setting/bodies|"
                   "#MiB = best/setting/memory_bytes 1048576 0|#us = best/setting/fault_ns 1000|"
                   "#rise = best/rise|#top = best/top_ns 1000|#GJK = best/gjk_rise|#fall = best/fall"));
}

void print(const thrash::RealisedCell& cell) {
    const thrash::Setting& setting = cell.setting;
    fmt::print("\nrealised: {}, {} tables, steps of {:.4g} s, {} bodies, {} MiB, {:g} us a fault\n",
               setting.table, setting.shared ? "shared" : "own", setting.time_step, setting.bodies,
               setting.memory_bytes >> 20, setting.fault_ns / 1000);
    if (!cell.reason.empty()) return fmt::print("  not measured: {}\n", cell.reason);
    for (const thrash::RealisedCurve& curve : cell.curves) {
        fmt::print("  {:<9} {:<5} us per query, measured (predicted; modelled):", curve.shape,
                   curve.algorithm);
        for (const thrash::RealisedPoint& point : curve.points)
            fmt::print(" {:.4g} ({:.4g}; {:.4g})", point.measured_ns / 1000, point.predicted_ns / 1000,
                       point.model_ns / 1000);
        fmt::print("\n");
    }
    fmt::print("  farthest from its prediction: a factor of {:.2f}\n", cell.worst_ratio());
}

bool all_same(const std::vector<thrash::RealisedCell>& cells) {
    for (const thrash::RealisedCell& cell : cells)
        for (const thrash::RealisedCurve& curve : cell.curves)
            for (const thrash::RealisedPoint& point : curve.points)
                if (!point.same_answers) return false;
    return true;
}

/// Throws std::invalid_argument for a type on which an algorithm does not run.
void check_that_serve(std::span<const bench::TableType* const> types,
                      std::initializer_list<std::string> algorithms) {
    for (const bench::TableType* type : types)
        for (const std::string& algorithm : algorithms)
            if (!type->serves(algorithm))
                throw std::invalid_argument(fmt::format("{} does not serve {}", type->name, algorithm));
}

/// The table types by these names, in their order: the first calibrates.
std::vector<std::string> tables_called(const std::vector<std::string>& names) {
    std::vector<std::string> tables;
    for (const std::string& name : names) {
        const auto types = bench::select_table_types(std::span(&name, 1));
        check_that_serve(types, {"vclip", "gjk"});
        for (const bench::TableType* type : types)
            if (std::ranges::find(tables, type->name) == tables.end()) tables.push_back(type->name);
    }
    return tables;
}

int run_thrash(const ThrashArguments& options, bool json) {
    thrash::Levels levels = options.levels;
    levels.tables = tables_called(levels.tables);
    levels.filling = levels.steps / 6;
    Progress progress("thrash", thrash::scenes_to_trace(levels) + options.realised);
    const thrash::Factorial factorial = thrash::run_factorial(
        levels, [&] { progress.advance(1, "traced"); }, stop_on_signals());
    if (stop_on_signals()) return exit_check_failed;
    std::vector<thrash::RealisedCell> cells;
    for (const thrash::Outcome& outcome : outcomes_to_realise(factorial, options.realised)) {
        if (stop_on_signals()) break;
        cells.push_back(thrash::realise(outcome, levels, options.wait_s * 1e9));
        progress.advance(1, "realised");
    }
    progress.clear();
    const nlohmann::json result = json_of(factorial, cells);
    if (json) {
        print_json(result);
    } else {
        print(result, factorial);
        for (const thrash::RealisedCell& cell : cells) print(cell);
    }
    return all_same(cells) && !stop_on_signals() ? exit_done : exit_check_failed;
}

void add_thrash(CLI::App& paging, Context& context) {
    auto [command, options] = add_command(
        paging, context, "thrash",
        "What could have made the paper's figure 8: every combination of what it leaves open, scored",
        run_thrash);
    thrash::Levels& levels = options.levels;
    add_layouts_option(*command, levels.tables);
    add_count(*command, "--bodies", levels.bodies, {2, 10'000, "bodies"},
              "how many bodies; every number is tried");
    add_count(*command, "--memory", levels.memories_mib, {1, 100'000, "MiB"}, "memories, MiB");
    add_number(*command, "--fault-ns", levels.fault_costs_ns, {1, 1e9, "ns"}, "costs of a fault, ns");
    add_count(*command, "--steps", levels.steps, {12, 10'000, "steps"},
              "steps traced; the first sixth of them counts nothing");
    add_count(*command, "--realised", options.realised, {0, 100, "cells"},
              "how many cells are made real; 0: none");
    add_number(*command, "--point-seconds", options.wait_s, {0.01, 100, "seconds"}, "of each realised point");
    add_seed_option(*command, levels.seed);
}

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
    for (const double mebibytes : options.limits) {
        limits.push_back(static_cast<std::uint64_t>(mebibytes * (1 << 20)));
        if (mebibytes > 0 && limits.back() < studies::page_bytes())
            throw std::invalid_argument(
                fmt::format("--limits {}: less than a page; 0 stands for no limit", mebibytes));
    }
    nlohmann::json results = nlohmann::json::array();
    const std::atomic<bool>& stop = stop_on_signals();  // a control group is to be removed
    const auto types = bench::select_table_types(options.layouts);
    check_that_serve(types, {options.algorithm});
    bool measured = false;
    for (const bench::TableType* type : types) {
        const studies::PagingResult result = studies::measure_paging(
            *type, options.algorithm, workload, [&](std::uint64_t) { return limits; }, stop);
        if (stop) {
            warn(fmt::format("stopped; nothing is kept of {}", type->name));
            break;
        }
        measured |= !result.rows.empty();
        if (json)
            results.push_back(json_of(result));
        else
            print(result);
    }
    if (json) print_json(nlohmann::json({{"paging", results}}));
    if (!measured && !stop) warn("nothing was measured; each table says why");
    return measured && !stop ? exit_done : exit_check_failed;
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
