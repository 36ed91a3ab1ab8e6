// SPDX-License-Identifier: MIT
//
// The paging run of a plan: hundreds of bodies with tables of their own under memory limits (paging.hpp).
// Runs the paper's cell, V-Clip on its own layout, and GJK, a lean layout and a smaller body, as far as this
// program has them. Limits are parts of what the tables touch, from an eighth to more than all.

#include <algorithm>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/studies/paging/paging.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::studies {

namespace {

constexpr const char* paging_run = "paging";

struct PagingPlan {
    std::size_t bodies = 0;
    std::uint64_t seed = 1;
    double rotation_step = 7.0 / 60;  ///< rad: the end of the paper's axis at 60 steps per second
    std::size_t steps = 6;            ///< of a pass
};

struct PagedCell {
    const char *shape, *algorithm, *table;
};

constexpr PagedCell paged_cells[] = {{"sphere386", "vclip", "aos_f64"},
                                     {"sphere386", "vclip", "lean_f64"},
                                     {"sphere386", "gjk", "aos_f64"},
                                     {"sphere38", "vclip", "aos_f64"}};

/// Returns parts of the touched bytes, at least what the process itself needs. Closer to all touched bytes,
/// prediction depends on how much memory the limit leaves for the tables, known to some 100 KiB.
std::vector<std::uint64_t> limits_for(std::uint64_t touched) {
    constexpr std::uint64_t least = 2 << 20;
    constexpr double parts[] = {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 1.125, 1.5};
    std::vector<std::uint64_t> limits;
    for (const double part : parts) {
        const auto limit = static_cast<std::uint64_t>(part * static_cast<double>(touched));
        limits.push_back(std::max(least, limit / 4096 * 4096));
    }
    limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
    return limits;
}

std::vector<PagedCell> cells_of_this_program() {
    std::vector<PagedCell> cells;
    for (const PagedCell& cell : paged_cells) {
        const bench::TableType* type = bench::find_table_type(cell.table);
        if (type && type->serves(cell.algorithm)) cells.push_back(cell);
    }
    return cells;
}

scene::SceneParameters parameters_of(const PagingPlan& plan) {
    return {{"bodies", static_cast<double>(plan.bodies)},
            {"rotation_step", plan.rotation_step},
            {"new_order", 1}};
}

store::CellRow row_of(const PagedCell& cell, const PagingPlan& plan, const Polyhedron& body) {
    store::CellRow row;
    row.run = row.scene = paging_run;
    row.scene_parameters = bench::parameters_json(parameters_of(plan));
    row.shape = cell.shape;
    row.shape_source = "built-in";
    row.algorithm = cell.algorithm;
    row.seed = plan.seed;
    row.queries = plan.steps * (plan.bodies - 1);
    bench::describe_cell(row, bench::table_type_called(cell.table), body);
    bench::name_cell(row, body);
    return row;
}

/// Adds the figures of limit i.
void add_limit(const PagingRow& limit, std::size_t i, std::vector<store::FigureRow>& figures) {
    const auto add = [&](const store::FigureName& name, double value, bool measured) {
        const bool there = !measured || limit.reason.empty();
        figures.push_back(
            {store::figure(name.of(std::to_string(i)), there ? std::optional(value) : std::nullopt,
                           limit.reason, "run as root, where memory control groups may be made"),
             "paging"});
    };
    add("paging.limit_bytes.{limit}", static_cast<double>(limit.limit_bytes), false);
    std::vector<measure::Figure> predicted;
    const std::string number = std::to_string(i);
    constexpr store::StartNames names{"paging.predicted_at_limit.{limit}",
                                      "paging.predicted_at_limit.{limit}.{start}"};
    store::add_values(names.of(number), limit.predicted_at_limit, predicted);
    for (measure::Figure& figure : predicted) figures.push_back({std::move(figure), "paging"});
    add("paging.held_bytes.{limit}", static_cast<double>(limit.table_pages_held.value_or(0) * page_bytes()),
        true);
    add("paging.predicted_at_held.{limit}", limit.predicted_at_held, true);
    add("paging.faults_per_query.{limit}", limit.faults_per_query, true);
    add("paging.us_per_query.{limit}", limit.ns_per_query / 1000, true);
}

std::vector<store::FigureRow> figures_of(const PagingResult& result) {
    std::vector<store::FigureRow> figures = {
        {store::figure("paging.table_bytes", result.table_bytes), "paging"},
        {store::figure("paging.touched_bytes", result.pages_touched * page_bytes()), "paging"},
        {store::figure("paging.keeps_recency", result.keeps_recency ? 1.0 : 0.0), "paging"}};
    for (std::size_t i = 0; i < result.rows.size(); ++i) add_limit(result.rows[i], i, figures);
    return figures;
}

void run_cell(const PagedCell& cell, const PagingPlan& plan, const Polyhedron& body, const std::string& build,
              store::Store& store, store::CellRow& row, const std::atomic<bool>& stop) {
    const scene::Workload workload = scene::make_scene("pressure", body, parameters_of(plan), plan.seed,
                                                       plan.steps * (plan.bodies - 1), {})
                                         .or_throw();
    const PagingResult result =
        measure_paging(bench::table_type_called(cell.table), cell.algorithm, workload, limits_for, stop);
    if (stop) return;
    row.status = result.reason.empty() ? store::CellStatus::verified : store::CellStatus::unavailable;
    row.reason = result.reason;
    store.put_cell(build, row, result.reason.empty() ? figures_of(result) : std::vector<store::FigureRow>{});
}

bool run_paging_study(const sweep::SweepWork& work, store::Store& store, const sweep::OnStudyRow& on_row,
                      const std::atomic<bool>& stop) {
    const PagingPlan plan{work.plan.count_of(paging_run), work.plan.seed};
    const std::string build = bench::this_build().id;
    for (const PagedCell& cell : cells_of_this_program()) {
        if (stop) return false;
        const Polyhedron body = scene::make_shape(cell.shape).or_throw();
        store::CellRow row = row_of(cell, plan, body);
        if (const auto stored = store.find_cell(build, row.hash))
            row.status = stored->status;
        else
            run_cell(cell, plan, body, build, store, row, stop);
        if (stop) return false;
        on_row(row.shape + " " + row.table, row.status);
    }
    return true;
}

}  // namespace

sweep::Study paging_study() {
    return {.name = paging_run,
            .counts = input::bodies_or_none,
            .rows = [](const sweep::SweepWork&) { return cells_of_this_program().size(); },
            .seconds_each = [](const sweep::SweepWork&) { return 6.0; },  // mostly of waiting for a disk
            .run = run_paging_study};
}

}  // namespace edgewise::studies
