// SPDX-License-Identifier: MIT
//
// Whether a ranking of tables by modelled misses depends on the replacement policy: true LRU is an
// approximation of what processors do, tree-PLRU and random replacement bound what it may hide.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "edgewise/reports/tables/cache_tables.hpp"

namespace edgewise::reports {

namespace {

/// Misses this close are no order.
constexpr double tie = 0.01;

struct Ranked {
    std::string table;
    double lru, other;
};

bool disagree(const Ranked& a, const Ranked& b) {
    const auto before = [](double x, double y) { return x < (1 - tie) * y; };
    return (before(a.lru, b.lru) && before(b.other, a.other)) ||
           (before(b.lru, a.lru) && before(a.other, b.other));
}

std::vector<GridCell> policy_row(const std::vector<GridCell>& group, const std::vector<Ranked>& tables) {
    std::size_t pairs = 0, changed = 0;
    std::string example = "–";
    for (std::size_t i = 0; i < tables.size(); ++i) {
        for (std::size_t j = i + 1; j < tables.size(); ++j) {
            ++pairs;
            if (!disagree(tables[i], tables[j])) continue;
            if (changed++ == 0)
                example =
                    fmt::format("{} ({:.3g}, {:.3g}) and {} ({:.3g}, {:.3g})", tables[i].table, tables[i].lru,
                                tables[i].other, tables[j].table, tables[j].lru, tables[j].other);
        }
    }
    std::vector<GridCell> row = group;
    row.insert(
        row.end(),
        {{std::to_string(pairs)}, {std::to_string(changed)}, {changed == 0 ? "no" : "yes"}, {example}});
    return row;
}

/// A level of a machine under another policy: "zen5/random" and "L1D".
using PolicyLevel = std::pair<std::string, std::string>;

std::vector<PolicyLevel> policy_levels(const ReportCell& cell) {
    std::vector<PolicyLevel> found;
    for (const store::FigureRow& figure : cell.figures) {
        const std::size_t slash = figure.name.find('/'), dot = figure.name.find('.', slash);
        if (figure.probe != "caches" || slash == std::string::npos || dot == std::string::npos) continue;
        const std::size_t end = figure.name.find('.', dot + 1);
        if (end == std::string::npos) continue;
        const PolicyLevel at{figure.name.substr(0, dot), figure.name.substr(dot + 1, end - dot - 1)};
        if (figure.name == store::level_misses.all.of(at.first, at.second).name()) found.push_back(at);
    }
    return found;
}

}  // namespace

PolicyCounts policy_counts(const ReportData& data) {
    PolicyCounts counts;
    for (const auto& row : policy_grid(data).rows) {
        counts.pairs += std::stoul(row[5].text);
        counts.changed += std::stoul(row[6].text);
    }
    return counts;
}

TextGrid policy_grid(const ReportData& data) {
    TextGrid grid{
        "Does the replacement policy change the ranking by misses? (LRU first)",
        columns_of("scene|shape|algorithm|machine and policy|level|#pairs of tables|#in another order|"
                   "ranking changes|first example (misses under LRU, under the policy)"),
        {}};
    using Group = std::tuple<std::string, std::string, std::string, std::string, std::string>;
    std::map<Group, std::vector<Ranked>> groups;
    for (const ReportCell* cell : modelled_cells(data)) {
        for (const auto& [policy, level] : policy_levels(*cell)) {
            const std::string machine = policy.substr(0, policy.find('/'));
            const auto lru = cell->figure(store::level_misses.all.of(machine, level)).value;
            const auto other = cell->figure(store::level_misses.all.of(policy, level)).value;
            if (lru && other)
                groups[{cell->scene_label, cell->shape, cell->algorithm, policy, level}].push_back(
                    {cell->table, *lru, *other});
        }
    }
    for (const auto& [key, tables] : groups) {
        const auto& [scene, shape, algorithm, policy, level] = key;
        grid.rows.push_back(policy_row({{scene}, {shape}, {algorithm}, {policy}, {level}}, tables));
    }
    return grid;
}

}  // namespace edgewise::reports
