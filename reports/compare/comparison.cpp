// SPDX-License-Identifier: MIT
#include "edgewise/reports/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/answer/answer_text.hpp"

namespace edgewise::reports {

namespace {

using CellsByKey = std::map<std::string, const ReportCell*>;

std::string key_of(const ReportCell& cell) {
    return fmt::format("{} {} {} {} {}", cell.scene, cell.scene_parameters, cell.shape, cell.algorithm,
                       cell.table);
}

std::string title_of(const ReportCell& cell) {
    return fmt::format("{} {} {} {}", cell.scene_label, cell.shape, cell.algorithm, cell.table);
}

CellsByKey cells_of(const ReportData& data) {
    CellsByKey cells;
    for (const ReportCell* cell : data.swept()) cells.emplace(key_of(*cell), cell);
    return cells;
}

/// What is compared exactly: costs that a layout or an algorithm decides, each less when it is better.
const std::vector<store::FigureName>& exact_costs() {
    static const std::vector<store::FigureName> names = {"error.mean_steps",
                                                         "error.fallbacks",
                                                         "lines.lines_per_query",
                                                         "lines.reads_per_query",
                                                         "bytes.total_bytes_per_edge",
                                                         "bytes.table_bytes",
                                                         "bytes.voronoi_planes",
                                                         "bytes.edge_geometry",
                                                         "bytes.vertex_coordinates",
                                                         "bytes.face_planes",
                                                         "bytes.topology",
                                                         "bytes.padding",
                                                         "bytes.pair_bytes",
                                                         "error.worst_error_given"};
    return names;
}

void compare_exact(const ReportCell& before, const ReportCell& after, Comparison& into) {
    const auto add = [&](const measure::Figure& was, const measure::Figure& is, const std::string& name) {
        if (!was.value || !is.value) return;
        ++into.figures;
        if (*was.value != *is.value)
            into.exact.push_back({title_of(after), name, is.unit, *was.value, *is.value});
    };
    for (const store::FigureName& name : exact_costs())
        add(before.figure(name), after.figure(name), name.probe() + "." + name.name());
    // Misses by machine and level: whichever both stores have.
    for (const store::FigureRow& figure : after.figures) {
        if (figure.probe == "caches" && figure.name.ends_with(".misses_per_query"))
            add(before.figure("caches", figure.name), figure, "caches." + figure.name);
    }
}

double ratio_or_0(std::optional<double> after, std::optional<double> before) {
    return after && before && *before > 0 ? *after / *before : 0;
}

std::optional<TimeChange> time_change(const ReportCell& before, const ReportCell& after) {
    const auto was = ranked_cell(before, 1), is = ranked_cell(after, 1);
    if (!was || !is) return std::nullopt;
    TimeChange change{title_of(after), is->low() / was->high(), is->ratio / was->ratio,
                      is->high() / was->low()};
    change.by_steps = ratio_or_0(is->steps, was->steps);
    const double lines = ratio_or_0(is->lines_per_query, was->lines_per_query);
    if (change.by_steps > 0 && lines > 0) {
        change.by_lines = lines / change.by_steps;
        change.by_cost = change.mid / lines;
    }
    return change;
}

/// The baseline's own cells are timed beside the baseline: what they differ by is noise.
void widen_noise(const ReportData& data, Comparison& comparison) {
    const Baseline baseline = baseline_of(data);
    for (const ReportCell* cell : data.swept()) {
        if (cell->algorithm != baseline.algorithm || cell->table != baseline.table) continue;
        const auto itself = ranked_cell(*cell, 1);
        if (!itself) continue;
        comparison.noise_low = std::min(comparison.noise_low, itself->ratio);
        comparison.noise_high = std::max(comparison.noise_high, itself->ratio);
    }
}

std::vector<Condition> conditions_of(const ReportData& before, const ReportData& after, bool same_bodies) {
    return {{"seed", before.meta_value("seed").value_or("?"), after.meta_value("seed").value_or("?")},
            {"bodies", "as they are", same_bodies ? "as they are" : "others"},
            {"processor", processor_text(before), processor_text(after)},
            {"compiler", before.build.compiler, after.build.compiler},
            {"flags", before.build.flags, after.build.flags},
            {"build type", before.build.build_type, after.build.build_type},
            {"source", before.build.git_revision, after.build.git_revision}};
}

}  // namespace

bool Comparison::is_slower(const TimeChange& change, double slack) const {
    return change.low > std::max(1 + slack, noise_high / noise_low);
}
bool Comparison::is_faster(const TimeChange& change, double slack) const {
    return change.high < std::min(1 / (1 + slack), noise_low / noise_high);
}

std::size_t Comparison::regressions(double slack) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(exact, &ExactChange::is_worse) +
        std::ranges::count_if(times, [&](const TimeChange& change) { return is_slower(change, slack); }));
}

Comparison compare(const ReportData& before, const ReportData& after) {
    const CellsByKey old_cells = cells_of(before), new_cells = cells_of(after);
    Comparison comparison;
    bool same_bodies = true;
    for (const auto& [key, cell] : new_cells) {
        const auto was = old_cells.find(key);
        if (was == old_cells.end()) {
            ++comparison.only_after;
            continue;
        }
        ++comparison.paired;
        same_bodies = same_bodies && (was->second->hash == cell->hash || was->second->seed != cell->seed);
        const std::size_t changes = comparison.exact.size();
        compare_exact(*was->second, *cell, comparison);
        if (auto change = time_change(*was->second, *cell)) {
            change->exact_same = comparison.exact.size() == changes;
            comparison.times.push_back(*change);
        }
    }
    comparison.only_before = old_cells.size() - comparison.paired;
    comparison.conditions = conditions_of(before, after, same_bodies);
    widen_noise(before, comparison);
    widen_noise(after, comparison);
    std::ranges::stable_sort(comparison.exact, [](const ExactChange& a, const ExactChange& b) {
        return std::pair(!a.is_worse(), -a.ratio()) < std::pair(!b.is_worse(), -b.ratio());
    });
    std::ranges::stable_sort(comparison.times,
                             [](const TimeChange& a, const TimeChange& b) { return a.mid > b.mid; });
    return comparison;
}

}  // namespace edgewise::reports
