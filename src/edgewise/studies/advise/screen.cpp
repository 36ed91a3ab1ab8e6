// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/screen.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::studies::advise {

sweep::SceneChoice usual_scene(bool own_tables, std::size_t bodies, double rotation_step) {
    sweep::SceneChoice scene{own_tables ? "pressure" : "tumble",
                             {{"bodies", static_cast<double>(bodies)}, {"rotation_step", rotation_step}}};
    if (!own_tables) scene.parameters["in_time_order"] = 1;
    return scene;
}

bool can_share(const CaseAsked& asked) {
    return scene::complete_parameters(asked.scene.name, {{"own_tables", 1.0}}).value.has_value();
}

sweep::SceneChoice scene_of(const CaseAsked& asked) {
    sweep::SceneChoice scene = asked.scene;
    if (can_share(asked)) scene.parameters["own_tables"] = asked.own_tables ? 1 : 0;
    return scene;
}

std::string sentence_of(const CaseAsked& asked) {
    const auto complete = scene::complete_parameters(asked.scene.name, asked.scene.parameters);
    std::string numbers;
    for (const char* name : {"bodies", "rotation_step"}) {
        if (complete && complete->contains(name)) numbers += fmt::format(", {} {}", name, complete->at(name));
    }
    const std::string tables = !can_share(asked)  ? ""
                               : asked.own_tables ? ", a table each"
                                                  : ", one table for all";
    const std::string rest =
        fmt::format("{}, {}, error <= {}", tables, to_string(asked.needs), asked.error_limit);
    if (!asked.recording.empty()) return fmt::format("recording {}{}", asked.shape.name, rest);
    return fmt::format("{}{}, {} vertices ({}){}", asked.scene.name, numbers, asked.shape.body.vertex_count(),
                       asked.shape.name, rest);
}

namespace {

void drop(ScreenedCell& cell, DroppedFor dropped_for, std::string why) {
    cell.dropped_for = dropped_for;
    cell.dropped = std::move(why);
}

/// Finds the bytes of one table, and whether answers are right and exact enough; then the shortest pass.
void look_at(ScreenedCell& cell, const CaseAsked& asked, const ScreenOptions& options,
             sweep::SharedQueries& shared, double clock_cost_ns) {
    const measure::Stopwatch watch;
    bench::RunnerOptions query;
    query.set_needs(asked.needs);
    sweep::PreparedCell ready(*cell.type, cell.algorithm, query);
    if (std::string problem = ready.load(shared.workload()); !problem.empty())
        return drop(cell, DroppedFor::failure, std::move(problem));
    cell.table_bytes = static_cast<double>(ready.runner().ledger().total());
    cell.bytes_per_edge = cell.table_bytes / static_cast<double>(asked.shape.body.edge_count());
    ready.check(shared);
    for (const truth::CheckedAnswer& answer : ready.checked())
        cell.error = std::max(cell.error, answer.band.over_scale(answer.error_given));
    if (!ready.wrong().empty())
        drop(cell, DroppedFor::failure, ready.wrong());
    else if (cell.error > asked.error_limit)
        drop(cell, DroppedFor::error, fmt::format("error {:.1e} is over {}", cell.error, asked.error_limit));
    cell.seconds = watch.elapsed_ns() * 1e-9;
    for (int pass = 0; pass < options.passes; ++pass) {
        const auto ns = ready.time(clock_cost_ns).all();
        if (ns && (pass == 0 || *ns < cell.ns)) cell.ns = *ns;
    }
}

/// Returns the cells in the order of the first look, which a time limit may cut short: the baseline, layouts
/// of their own, and layouts that hardly differ from another.
std::vector<ScreenedCell> cells_to_look_at() {
    std::vector<ScreenedCell> cells;
    for (const bench::TableType& type : bench::table_types()) {
        for (const std::string& algorithm : type.algorithms) {
            ScreenedCell& cell = cells.emplace_back();
            cell.type = &type;
            cell.algorithm = algorithm;
        }
    }
    std::ranges::stable_sort(cells, {}, [](const ScreenedCell& cell) {
        return std::pair(!cell.is_baseline(), !cell.type->variant_of.empty());
    });
    return cells;
}

/// Drops cells that take longer than the fastest by more than the options allow.
void drop_slow_ones(std::vector<ScreenedCell>& cells, double slowest) {
    double fastest = 0;
    for (const ScreenedCell& cell : cells)
        if (cell.is_in() && (fastest == 0 || cell.ns < fastest)) fastest = cell.ns;
    for (ScreenedCell& cell : cells) {
        if (cell.is_in() && cell.ns > slowest * fastest && !cell.is_baseline())
            drop(cell, DroppedFor::time,
                 fmt::format("{:.2f} times as long as the fastest", cell.ns / fastest));
    }
}

}  // namespace

bool ScreenedCell::is_baseline() const {
    return algorithm == sweep::baseline_algorithm && type->name == sweep::baseline_table;
}

std::string ScreenedCell::name() const { return contender_name(algorithm, type->name); }

bool Screen::is_inexact(const std::string& name) const {
    const auto found = std::ranges::find(cells, name, &ScreenedCell::name);
    return found != cells.end() && found->dropped_for == DroppedFor::error;
}

Screen screen(const CaseAsked& asked, const ScreenOptions& options, const std::function<bool()>& stop) {
    sweep::Plan plan;
    plan.queries = options.queries;
    plan.checked = options.checked;
    plan.seed = asked.seed;
    sweep::SharedQueries shared(plan, scene_of(asked), asked.shape);
    const double clock_cost_ns = measure::calibrate();
    Screen result;
    for (ScreenedCell& cell : cells_to_look_at()) {
        if (result.left_out > 0 || stop()) {
            ++result.left_out;
            continue;
        }
        look_at(cell, asked, options, shared, clock_cost_ns);
        result.cells.push_back(std::move(cell));
    }
    drop_slow_ones(result.cells, options.slowest);
    std::ranges::stable_sort(result.cells, [](const ScreenedCell& a, const ScreenedCell& b) {
        return std::pair(!a.is_in(), a.ns) < std::pair(!b.is_in(), b.ns);
    });
    return result;
}

namespace {

/// Names the fastest cell with the other sharing, and says what becomes of the recommended cell.
std::string other_sharing(const CaseAsked& asked, const std::vector<ScreenedCell>& other_tables,
                          const Taken& taken) {
    const ScreenedCell& best = other_tables.front();
    const std::string text = fmt::format(
        "{}: {}, {:.0f} ns at a first look",
        asked.own_tables ? "one table for all bodies" : "a table for each body", best.name(), best.ns);
    const auto then = std::ranges::find(other_tables, taken.name, &ScreenedCell::name);
    if (then == other_tables.begin()) return text;
    if (then == other_tables.end()) return text + fmt::format("; {} is then dropped", taken.name);
    return text + fmt::format("; {} then takes {:.0f} ns", taken.name, then->ns);
}

}  // namespace

std::vector<std::string> what_would_change(const CaseAsked& asked, const Screen& screen,
                                           const std::vector<ScreenedCell>& other_tables,
                                           const Taken& taken) {
    std::vector<std::string> changes;
    if (!other_tables.empty()) changes.push_back(other_sharing(asked, other_tables, taken));
    const auto smaller = std::ranges::find_if(screen.cells, [&](const ScreenedCell& cell) {
        return cell.dropped_for == DroppedFor::error && cell.bytes_per_edge < taken.bytes_per_edge;
    });
    if (smaller != screen.cells.end())
        changes.push_back(
            fmt::format("an error of {:.1e} allowed: {} becomes possible ({:.1f} bytes per edge, {:.0f} ns)",
                        smaller->error, smaller->name(), smaller->bytes_per_edge, smaller->ns));
    if (taken.error > 0)
        changes.push_back(
            fmt::format("an error below {:.1e} asked for: {} is dropped", taken.error, taken.name));
    return changes;
}

double race_seconds(const RaceCost& cost, const RacePlan& plan) {
    return (plan.processes + 1) * (cost.process + plan.rounds * cost.round) + cost.traces;
}

RacePlan race_within(double seconds, const RaceCost& cost) {
    for (RacePlan plan = whole_race; plan.processes >= least_race.processes; --plan.processes) {
        for (plan.rounds = whole_race.rounds; plan.rounds >= least_race.rounds; --plan.rounds)
            if (race_seconds(cost, plan) <= seconds) return plan;
    }
    return least_race;
}

bool TimeLimit::begin_piece() {
    const double now = clock_();
    if (begun_) longest_ = std::max(longest_, now - *begun_);
    begun_ = now;
    return now + longest_ < end_;
}

namespace {

/// Returns the time that the levels take to answer these misses, given level by level.
double waiting_ns(const std::vector<double>& misses, std::span<const double> latencies_ns) {
    double sum = 0;
    for (std::size_t level = 0; level < misses.size(); ++level) {
        const bool last = level + 1 == misses.size();
        const double deeper = last ? 0 : misses[level + 1];
        sum += (misses[level] - deeper) *
               (last ? latencies_ns.back() : latencies_ns[std::min(level, latencies_ns.size() - 1)]);
    }
    return sum;
}

}  // namespace

void predict(CacheCost& cost, std::span<const double> latencies_ns) {
    if (latencies_ns.empty() || !cost.in_cache_ns) return;
    for (const auto& [machine, misses] : cost.misses)
        cost.predicted_ns[machine] = *cost.in_cache_ns + waiting_ns(misses, latencies_ns);
}

}  // namespace edgewise::studies::advise
