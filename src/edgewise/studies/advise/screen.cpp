// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/screen.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/sweep/shared_queries.hpp"
#include "edgewise/sweep/verify.hpp"

namespace edgewise::studies::advise {

namespace {

bool is_baseline(const ScreenedCell& cell) {
    return cell.algorithm == "vclip" && cell.type->name == "aos_f64";
}

/// Bytes of one table, and whether the answers are right and exact enough; then the shortest of some passes.
void look_at(ScreenedCell& cell, const CaseAsked& asked, const ScreenOptions& options,
             sweep::SharedQueries& shared, double clock_cost_ns) {
    const scene::Workload& workload = shared.workload();
    const auto runner = cell.type->make_runner(cell.algorithm);
    bench::RunnerOptions query;
    query.set_needs(asked.needs);
    runner->configure(query);
    cell.out = runner->load(workload);
    if (!cell.out.empty()) return;
    cell.table_bytes = static_cast<double>(runner->ledger().total());
    cell.bytes_per_edge = cell.table_bytes / static_cast<double>(asked.shape.body.edge_count());
    const std::vector<Distance> answers = runner->answer();
    double steps = 0;
    std::vector<std::uint8_t> in_contact;
    for (const Distance& answer : answers) {
        steps += answer.steps;
        in_contact.push_back(answer.status != Status::separated);
    }
    cell.steps = steps / static_cast<double>(answers.size());
    const auto checked =
        sweep::check_answers(shared, runner->stored_bodies(), answers, cell.type->eps, query.query);
    for (const measure::CheckedAnswer& answer : checked)
        cell.error = std::max(cell.error, answer.error_given);
    cell.out = sweep::what_is_wrong(shared, checked, cell.type->eps);
    if (cell.out.empty() && cell.error > asked.error_limit)
        cell.out = fmt::format("error {:.1e} is over {:.0e}", cell.error, asked.error_limit);
    for (int pass = 0; pass < options.passes; ++pass) {
        const auto ns = runner->time(in_contact, clock_cost_ns).all();
        if (ns && (pass == 0 || *ns < cell.ns)) cell.ns = *ns;
    }
}

/// Who takes longer than the fastest by more than the options allow.
void leave_out_slow_ones(std::vector<ScreenedCell>& cells, double slowest) {
    double fastest = 0;
    for (const ScreenedCell& cell : cells)
        if (cell.out.empty() && (fastest == 0 || cell.ns < fastest)) fastest = cell.ns;
    for (ScreenedCell& cell : cells) {
        cell.is_slow = cell.out.empty() && cell.ns > slowest * fastest && !is_baseline(cell);
        if (cell.is_slow) cell.out = fmt::format("{:.2f} times as long as the fastest", cell.ns / fastest);
    }
}

}  // namespace

std::string ScreenedCell::name() const {
    return fmt::format("{} on {}", algorithm == "vclip" ? "V-Clip" : "GJK", type->name);
}

Screen screen(const CaseAsked& asked, const ScreenOptions& options, const std::function<bool()>& stop) {
    sweep::Plan plan;
    plan.queries = options.queries;
    plan.checked = options.checked;
    plan.seed = asked.seed;
    sweep::SharedQueries shared(plan, scene_of(asked), asked.shape);
    const double clock_cost_ns = measure::calibrate();
    Screen result;
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) {
            result.stopped = result.stopped || stop();
            if (result.stopped) continue;
            ScreenedCell cell;
            cell.type = &type;
            cell.algorithm = algorithm;
            look_at(cell, asked, options, shared, clock_cost_ns);
            result.cells.push_back(std::move(cell));
        }
    }
    leave_out_slow_ones(result.cells, options.slowest);
    std::ranges::stable_sort(result.cells, [](const ScreenedCell& a, const ScreenedCell& b) {
        return std::pair(!a.out.empty(), a.ns) < std::pair(!b.out.empty(), b.ns);
    });
    return result;
}

}  // namespace edgewise::studies::advise
