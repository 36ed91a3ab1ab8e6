// SPDX-License-Identifier: MIT
#include "edgewise/studies/gate/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

namespace edgewise::studies {

namespace {

std::map<std::string, const GateEntry*> entries_by_name(const GateRecord& record) {
    std::map<std::string, const GateEntry*> entries;
    for (const GateEntry& entry : record.entries) entries[entry.name()] = &entry;
    return entries;
}

GateVerdict verdict_of(const GateRatio& now, const GateRatio& baseline, double slack) {
    if (now.low > baseline.value * (1 + slack)) return GateVerdict::slower;
    return now.high < baseline.value / (1 + slack) ? GateVerdict::faster : GateVerdict::same;
}

void note_difference(const char* what, const std::string& baseline, const std::string& now,
                     std::vector<std::string>& notes) {
    if (baseline != now)
        notes.push_back(fmt::format("another {}: the baseline's is '{}', this is '{}'", what, baseline, now));
}

/// What was divided by a reference grows as the reference shrinks, and hides behind one that grows.
void note_references(GateReport& report) {
    for (const GateRow& row : report.rows) {
        if (row.now.over != GateOver::kernel || row.verdict == GateVerdict::same) continue;
        report.notes.push_back(
            fmt::format("the reference {} changed by {:.2f}: other ratios of {} {} are to be read with that",
                        row.now.name(), row.change(), row.now.scene, row.now.shape));
    }
}

}  // namespace

const char* to_string(GateVerdict verdict) {
    constexpr const char* names[] = {"slower", "same", "faster"};
    return names[static_cast<std::size_t>(verdict)];
}

std::size_t GateReport::count(GateVerdict verdict) const {
    return static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [verdict](const GateRow& row) { return row.verdict == verdict; }));
}

GateReport compare_gate(const GateRecord& baseline, const GateRecord& now, double slack) {
    assert(slack >= 0);
    GateReport report;
    note_difference("machine", baseline.machine, now.machine, report.notes);
    note_difference("compiler", baseline.compiler, now.compiler, report.notes);
    note_difference("set of flags", baseline.flags, now.flags, report.notes);
    note_difference("build type", baseline.build_type, now.build_type, report.notes);
    auto kept = entries_by_name(baseline);
    for (const GateEntry& entry : now.entries) {
        const auto found = kept.find(entry.name());
        if (found == kept.end() || found->second->over != entry.over) {
            report.added.push_back(entry.name());
            continue;
        }
        const GateRatio& before = found->second->ratio;
        report.rows.push_back({entry, before, verdict_of(entry.ratio, before, slack)});
        kept.erase(found);
    }
    for (const auto& [name, entry] : kept) report.missing.push_back(name);
    std::stable_sort(report.rows.begin(), report.rows.end(),
                     [](const GateRow& a, const GateRow& b) { return a.least_change() > b.least_change(); });
    note_references(report);
    return report;
}

std::vector<std::string> suspect_groups(const GateReport& report) {
    std::vector<std::string> groups;
    for (const GateRow& row : report.rows) {
        const std::string group = gate_group_name(row.now.scene, row.now.shape);
        if (row.verdict == GateVerdict::slower &&
            std::find(groups.begin(), groups.end(), group) == groups.end())
            groups.push_back(group);
    }
    return groups;
}

void look_again(GateRecord& now, const GateReport& report, const GateRecord& again) {
    std::set<std::string> suspects;
    for (const GateRow& row : report.rows)
        if (row.verdict == GateVerdict::slower) suspects.insert(row.now.name());
    const auto second = entries_by_name(again);
    for (GateEntry& entry : now.entries) {
        const auto found = second.find(entry.name());
        if (found == second.end() || !suspects.contains(entry.name())) continue;
        if (found->second->ratio.low < entry.ratio.low) entry.ratio = found->second->ratio;
    }
}

}  // namespace edgewise::studies
