// SPDX-License-Identifier: MIT
//
// Made cells for the answer: a ratio with its rounds, an error, bytes. Every cell of one scene is timed
// in the same rounds as a baseline of 100 ns.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct TimedCell {
    std::string algorithm, layout, precision = "f64";
    std::vector<double> ratios;  ///< of the rounds; the median is the cell's
    double error = 1e-15;
    double bytes_per_edge = 234;
    std::string axes = {};
    store::CellStatus status = store::CellStatus::verified;
};

inline const std::string shared_tables = R"({"bodies":100,"rotation_step":0.1})",
                         own_tables_scene = R"({"bodies":600,"rotation_step":0.1,"own_tables":1})";

inline ReportCell answer_cell(const TimedCell& made, const std::string& parameters = shared_tables,
                              const std::string& shape = "sphere386") {
    ReportCell cell;
    cell.scene = "tumble", cell.scene_parameters = parameters;
    cell.scene_label = parameters == own_tables_scene ? "own" : "shared";
    cell.shape = shape, cell.shape_source = "built-in", cell.vertices = shape == "cube8" ? 8 : 386,
    cell.edges = 1152;
    cell.algorithm = made.algorithm, cell.layout = made.layout, cell.precision = made.precision;
    cell.table = made.layout + "_" + made.precision + (made.axes.empty() ? "" : " " + made.axes);
    cell.axes = made.axes, cell.status = made.status;
    cell.hash = made.algorithm + cell.table + parameters + shape;
    const double ratio = made.ratios[made.ratios.size() / 2];
    cell.figures = {{{"all_ns", 100 * ratio, "ns"}, "time"},
                    {{"all_ratio", ratio, "1"}, "time"},
                    {{"worst_error_given", made.error, "scale"}, "error"},
                    {{"mean_steps", 3.0, "steps"}, "error"},
                    {{"total_bytes_per_edge", made.bytes_per_edge, "B/edge"}, "bytes"},
                    {{"table_bytes", 1152 * made.bytes_per_edge, "B"}, "bytes"},
                    {{"requested_bytes", 6e5 * made.bytes_per_edge, "B"}, "memory"},
                    {{"tables", parameters == own_tables_scene ? 600.0 : 1.0, "tables"}, "memory"},
                    {{"instructions", std::nullopt, "1", "no counters here", "bare metal"}, "counters"}};
    for (std::size_t i = 0; i < made.ratios.size(); ++i) {
        measure::Round round{static_cast<int>(i), {}, {}};
        round.timing = {10, 0, 1000 * made.ratios[i], 0};
        round.baseline = {10, 0, 1000, 0};
        cell.rounds.push_back(round);
    }
    return cell;
}

}  // namespace edgewise::reports
