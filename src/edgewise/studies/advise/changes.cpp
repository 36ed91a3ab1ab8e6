// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/changes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace edgewise::studies::advise {

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

}  // namespace edgewise::studies::advise
