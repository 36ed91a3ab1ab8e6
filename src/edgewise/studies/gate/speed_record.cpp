// SPDX-License-Identifier: MIT
#include "edgewise/studies/gate/speed_record.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "edgewise/measure/statistics.hpp"

namespace edgewise::studies {

namespace {

using measure::ComparedRow;
using measure::FigureRecord;
using measure::Outcome;
using measure::RecordComparison;
using measure::RecordRow;

std::string word_of(const std::string& cell, int number) {
    std::istringstream words(cell);
    std::string word;
    for (int i = 0; i <= number; ++i)
        if (!(words >> word)) return {};
    return word;
}

}  // namespace

std::string gate_group_name(const std::string& scene, const std::string& shape) {
    return scene + " " + shape;
}
std::string gate_group_of(const std::string& cell) {
    return gate_group_name(word_of(cell, 2), word_of(cell, 3));
}
std::string gate_table_of(const std::string& cell) { return word_of(cell, 1); }

std::optional<RecordRow> gate_row(std::string cell, std::string figure, std::span<const double> times,
                                  std::span<const double> beside) {
    const std::vector<double> ratios = measure::paired_ratios(times, beside);
    if (!std::all_of(ratios.begin(), ratios.end(), [](double ratio) { return ratio > 0; }))
        return std::nullopt;
    const auto middle = measure::median(ratios);
    const auto interval = measure::bootstrap_median(ratios);
    if (!middle || !interval) return std::nullopt;
    // The interval of a bootstrap may miss the median of a sample of few values.
    return RecordRow{std::move(cell),
                     std::move(figure),
                     *middle,
                     std::min(interval->lower, *middle),
                     std::max(interval->upper, *middle),
                     true};
}

RecordComparison compare_speed(FigureRecord baseline, const FigureRecord& now) {
    for (RecordRow& row : baseline.rows) row.low = row.high = row.value;
    RecordComparison found = compare(baseline, now);
    for (ComparedRow& row : found.rows)
        if (row.is.figure == over_kernel && (row.outcome == Outcome::worse || row.outcome == Outcome::better))
            row.note = "other ratios of " + gate_group_of(row.is.cell) + " are divided by this one's time";
    return found;
}

std::vector<std::string> suspect_groups(const RecordComparison& found) {
    std::vector<std::string> groups;
    for (const ComparedRow& row : found.rows) {
        const std::string group = gate_group_of(row.is.cell);
        if (row.outcome == Outcome::worse && std::ranges::find(groups, group) == groups.end())
            groups.push_back(group);
    }
    return groups;
}

void look_again(FigureRecord& now, const RecordComparison& found, const FigureRecord& again) {
    std::set<std::string> suspects;
    for (const ComparedRow& row : found.rows)
        if (row.outcome == Outcome::worse) suspects.insert(row.is.cell);
    for (RecordRow& row : now.rows) {
        const auto second = std::ranges::find(again.rows, row.cell, &RecordRow::cell);
        if (second == again.rows.end() || !suspects.contains(row.cell)) continue;
        if (second->low < row.low) row = *second;
    }
}

}  // namespace edgewise::studies
