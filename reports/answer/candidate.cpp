// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/candidate.hpp"

#include <fmt/core.h>

namespace edgewise::reports {

std::string algorithm_title(const std::string& algorithm) {
    if (algorithm == "vclip") return "V-Clip";
    return algorithm == "gjk" ? "GJK" : algorithm;
}

std::string Candidate::name() const {
    if (cell->judged()) return cell->layout;
    return fmt::format("{} on {}", algorithm_title(cell->algorithm), table);
}

std::optional<Candidate> candidate_of(const ReportCell& cell, double error_limit) {
    const measure::Figure ns = cell.figure(store::all_time.ns), ratio = cell.figure(store::all_time.ratio);
    if (!cell.is_timed() || !ns.value || !ratio.value || !(*ratio.value > 0)) return std::nullopt;
    std::vector<double> ratios;
    for (const measure::Round& round : cell.rounds)
        if (const auto one = round.ratio(&measure::Timing::all)) ratios.push_back(*one);
    const auto error = cell.figure("error.worst_error_given").value;
    return Candidate{.cell = &cell,
                     .table = cell.table.substr(0, cell.table.find(' ')),
                     .ns = *ns.value,
                     .ratio = *ratio.value,
                     .interval = median_interval(std::move(ratios)),
                     .worst_error = error,
                     .bytes_per_edge = cell.figure("bytes.total_bytes_per_edge").value,
                     .table_bytes = cell.figure("bytes.table_bytes").value,
                     .scene_bytes = cell.figure("memory.requested_bytes").value,
                     .tables = cell.figure("memory.tables").value,
                     .lines_per_query = cell.figure("lines.lines_per_query").value,
                     .steps = cell.figure("error.mean_steps").value,
                     .meets_error = error && *error <= error_limit};
}

}  // namespace edgewise::reports
