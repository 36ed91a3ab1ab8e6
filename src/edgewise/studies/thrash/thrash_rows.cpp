// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/thrash_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::studies::thrash {

namespace {

constexpr const char* thrash_run = "thrash";
constexpr const char* large_shape = "sphere386";

nlohmann::json parameters_of(const Setting& setting, const std::vector<OldMachine>& machines) {
    return {{"mechanism", mechanism_names[static_cast<std::size_t>(setting.mechanism)]},
            {"intensity", setting.intensity},
            {"own_tables", setting.shared ? 0 : 1},
            {"time_step", setting.time_step},
            {"machine", machines[setting.machine].name()}};
}

store::CellRow row_of(const char* run, const nlohmann::json& parameters, const std::string& shape,
                      const std::string& algorithm, const std::string& table, const Levels& levels) {
    const Polyhedron body = scene::make_shape(shape).or_throw();
    const bench::TableType& type = bench::table_type_called(table);
    store::CellRow row;
    row.run = row.scene = run;
    row.scene_parameters = parameters.dump();
    row.shape = shape;
    row.shape_source = "built-in";
    row.algorithm = algorithm;
    row.seed = levels.seed;
    row.status = store::CellStatus::verified;
    bench::describe_cell(row, type, body);
    bench::name_cell(row, body);
    return row;
}

std::string setting_text(const Setting& setting) {
    return fmt::format("{}_{}MiB_{:.0f}ns", setting.bodies, setting.memory_bytes >> 20, setting.fault_ns);
}

using Figures = std::vector<store::FigureRow>;

void add_figure(Figures& to, const store::FigureName& name, double value) {
    to.push_back({store::figure(name, value), "thrash"});
}

void add_best(const Outcome& best, Figures& figures) {
    add_figure(figures, "thrash.best_facts", best.score.count());
    add_figure(figures, "thrash.best.bodies", static_cast<double>(best.setting.bodies));
    add_figure(figures, "thrash.best.memory_bytes", static_cast<double>(best.setting.memory_bytes));
    add_figure(figures, "thrash.best.fault_ns", best.setting.fault_ns);
    add_figure(figures, "thrash.best.rise", best.score.rise);
    add_figure(figures, "thrash.best.top_us", best.score.top_ns / 1000);
    add_figure(figures, "thrash.best.gjk_rise", best.score.gjk_rise);
    add_figure(figures, "thrash.best.fall", best.score.fall);
}

Figures figures_of(const OutcomeGroup& group, const Factorial& factorial) {
    Figures figures;
    add_figure(figures, "thrash.settings", static_cast<double>(group.outcomes.size()));
    for (std::size_t i = 0; i < fact_names.size(); ++i)
        add_figure(figures, store::FigureName("thrash.settings_with.{fact}").of(fact_names[i]),
                   static_cast<double>(group.with(static_cast<Fact>(i))));
    add_figure(figures, "thrash.settings_with_all", static_cast<double>(group.with_all()));
    add_best(group.best(), figures);
    for (const Calibration& calibration : factorial.calibrations) {
        if (calibration.machine != group.setting.machine || calibration.time_step != group.setting.time_step)
            continue;
        add_figure(figures, "thrash.ns_per_read", calibration.ns_per_read);
        for (const CalibrationPoint& point : calibration.points)
            add_figure(figures,
                       store::FigureName("thrash.calibrated.{figure}").of(std::to_string(point.figure)),
                       point.model_ns(calibration.ns_per_read) / point.top_ns);
    }
    // The picture of the region is that of the first machine.
    if (group.setting.machine == 0)
        for (const Outcome* outcome : group.outcomes)
            add_figure(figures,
                       store::FigureName("thrash.facts.{setting}").of(setting_text(outcome->setting)),
                       outcome->score.mask());
    return figures;
}

Figures figures_of(const RealisedCurve& curve) {
    Figures figures;
    for (const RealisedPoint& point : curve.points) {
        const std::string speed = fmt::format("{:g}", point.speed);
        const auto add = [&](const store::FigureName& name, double value) {
            add_figure(figures, name.of(speed), value);
        };
        add("thrash.predicted_us.{speed}", point.predicted_ns / 1000);
        add("thrash.measured_us.{speed}", point.measured_ns / 1000);
        add("thrash.model_us.{speed}", point.model_ns / 1000);
        add("thrash.in_memory_us.{speed}", point.in_memory_ns / 1000);
        add("thrash.predicted_faults.{speed}", point.predicted_faults);
        add("thrash.measured_faults.{speed}", point.faults);
        add("thrash.queries.{speed}", static_cast<double>(point.queries));
    }
    return figures;
}

void store_cell(const RealisedCell& cell, std::size_t number, const Factorial& factorial,
                const Levels& levels, const std::string& build, store::Store& store) {
    nlohmann::json parameters = parameters_of(cell.setting, factorial.machines);
    parameters["number"] = number;
    parameters["bodies"] = cell.setting.bodies;
    parameters["memory_mib"] = cell.setting.memory_bytes >> 20;
    parameters["fault_us"] = cell.setting.fault_ns / 1000;
    const auto put = [&](const std::string& shape, const std::string& algorithm, const Figures& figures,
                         bool right) {
        store::CellRow row =
            row_of("thrash_realised", parameters, shape, algorithm, cell.setting.table, levels);
        if (!cell.reason.empty()) row.status = store::CellStatus::unavailable, row.reason = cell.reason;
        if (!right) row.status = store::CellStatus::failed, row.reason = "answers under the pager differ";
        store.put_cell(build, row, figures);
    };
    for (const RealisedCurve& curve : cell.curves)
        put(curve.shape, curve.algorithm, figures_of(curve),
            std::all_of(curve.points.begin(), curve.points.end(),
                        [](const RealisedPoint& point) { return point.same_answers; }));
    if (cell.curves.empty()) put(large_shape, "vclip", {}, true);
}

/// The row that is stored last: where it is, all are.
store::CellRow last_row(const Levels& levels) {
    return row_of(thrash_run, {{"complete", 1}, {"steps", levels.steps}}, large_shape, "vclip",
                  levels.tables.front(), levels);
}

}  // namespace

std::size_t OutcomeGroup::with(Fact fact) const {
    return static_cast<std::size_t>(std::count_if(outcomes.begin(), outcomes.end(), [&](const Outcome* one) {
        return one->score.holds[static_cast<std::size_t>(fact)];
    }));
}

std::size_t OutcomeGroup::with_all() const {
    return static_cast<std::size_t>(std::count_if(
        outcomes.begin(), outcomes.end(), [](const Outcome* one) { return one->score.count() == 4; }));
}

const Outcome& OutcomeGroup::best() const {
    return **std::max_element(outcomes.begin(), outcomes.end(), [](const Outcome* a, const Outcome* b) {
        if (a->score.count() != b->score.count()) return a->score.count() < b->score.count();
        return std::abs(std::log(a->score.rise / 12)) > std::abs(std::log(b->score.rise / 12));
    });
}

std::vector<OutcomeGroup> groups_of(const Factorial& factorial) {
    std::vector<OutcomeGroup> groups;
    for (const Outcome& outcome : factorial.outcomes) {
        Setting setting = outcome.setting;
        setting.bodies = 0;
        setting.memory_bytes = 0;
        setting.fault_ns = 0;
        auto group = std::ranges::find(groups, setting, &OutcomeGroup::setting);
        if (group == groups.end()) group = groups.insert(groups.end(), {setting, {}});
        group->outcomes.push_back(&outcome);
    }
    return groups;
}

namespace {

Levels levels_of(const sweep::SweepWork& work) {
    Levels levels;
    levels.seed = work.plan.seed;
    return levels;
}

/// Returns the number of scenes to trace and of cells to make real; none without the levels' table types.
std::size_t rows(const sweep::SweepWork& work) {
    const Levels levels = levels_of(work);
    return std::ranges::all_of(levels.tables, bench::find_table_type)
               ? scenes_to_trace(levels) + realised_cells
               : 0;
}

/// Traces, scores, makes the best cells real and stores all of it, unless the build's rows are there.
bool run(const sweep::SweepWork& work, store::Store& store, const sweep::OnStudyRow& on_row,
         const std::atomic<bool>& stop) {
    const Levels levels = levels_of(work);
    const std::string build = bench::this_build().id;
    const auto on_scene = [&] { on_row("figure 8", store::CellStatus::verified); };
    if (store.find_cell(build, last_row(levels).hash)) return true;
    const Factorial factorial = run_factorial(levels, on_scene, stop);
    if (stop) return false;
    std::size_t number = 0;
    for (const Outcome& outcome : outcomes_to_realise(factorial, realised_cells)) {
        if (stop) return false;
        store_cell(realise(outcome, levels, budget_of_a_point_ns), ++number, factorial, levels, build, store);
        on_scene();
    }
    for (const OutcomeGroup& group : groups_of(factorial)) {
        const store::CellRow row = row_of(thrash_run, parameters_of(group.setting, factorial.machines),
                                          large_shape, "vclip", group.setting.table, levels);
        store.put_cell(build, row, figures_of(group, factorial));
    }
    store.put_cell(build, last_row(levels), {});
    return true;
}

}  // namespace

}  // namespace edgewise::studies::thrash

namespace edgewise::studies {

sweep::Study thrash_study() {
    return {.name = thrash::thrash_run,
            .counts = {0, 1, "runs"},
            .rows = thrash::rows,
            .seconds_each = [](const sweep::SweepWork&) { return 5.0; },
            .run = thrash::run};
}

}  // namespace edgewise::studies
