// SPDX-License-Identifier: MIT
//
// The tables of the report, as grids. These functions decide the content and the order of each, once, for
// every page.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

enum class PairKind { Separated, Overlapping };
[[nodiscard]] std::string pair_name(PairKind kind);  ///< "separated" | "overlapping"
[[nodiscard]] const store::QueryTime& times_of(PairKind kind);

/// Returns the tables of a machine (measure::machine_json, as a store keeps it): processor and further facts,
/// caches, counters.
[[nodiscard]] std::vector<TextGrid> machine_grids(const nlohmann::json& machine);
/// Returns facts about the run and the build: key and value.
[[nodiscard]] TextGrid facts_grid(const ReportData& data);
/// Name and full parameters of every scene.
[[nodiscard]] TextGrid scenes_grid(const ReportData& data);
/// Cells that failed, then cells that were unavailable, with their reasons; those of one shape and reason are
/// a row.
[[nodiscard]] TextGrid problems_grid(const ReportData& data);

/// Returns the cells in the data's order, of one shape and of one scene; an empty name means all.
[[nodiscard]] std::vector<const ReportCell*> verified_cells(const ReportData& data,
                                                            const std::string& shape = {},
                                                            const std::string& scene_label = {});
/// Returns a figure by which cells are sorted, smallest first: those without it go last.
[[nodiscard]] inline double or_infinity(const ReportCell& cell, const store::FigureName& figure) {
    return cell.figure(figure).value.value_or(std::numeric_limits<double>::infinity());
}
/// The shape that the short tables and the first view of the charts show: sphere386 if swept, else the
/// largest.
[[nodiscard]] std::string reference_shape(const ReportData& data);
/// The scene of the table of layouts: the warm one if it was swept, since its queries are what layouts are
/// for, else the first.
[[nodiscard]] std::string reference_scene(const ReportData& data);
/// Names of the bytes probe's components, the paper's three first.
[[nodiscard]] std::vector<std::string> byte_components(const ReportData& data);
/// Bytes per edge by component; an empty `shape` means all of them.
[[nodiscard]] TextGrid bytes_grid(const ReportData& data, const std::string& shape);

/// Cache lines per query, time to build and refit, part ever materialised: one scene, the reference shape.
[[nodiscard]] TextGrid layout_cost_grid(const ReportData& data);
/// Counters of processor and kernel, and the heap's growth: one scene, the reference shape.
[[nodiscard]] TextGrid counters_grid(const ReportData& data);
/// Bytes of all tables next to the time of queries, in scenes with more than a few tables.
[[nodiscard]] TextGrid scene_memory_grid(const ReportData& data);

/// One table at many scales compared with a table for each: what sharing saves in bytes and costs in time;
/// cells that measured it (probe scale), by scene and shape.
[[nodiscard]] TextGrid scale_grid(const ReportData& data);

/// Returns the cells with modelled caches, fewest misses of the first machine first; by scene.
[[nodiscard]] std::vector<const ReportCell*> modelled_cells(const ReportData& data);
/// Machines with figures, in order of name; not those under another policy.
[[nodiscard]] std::vector<std::string> modelled_machines(const ReportData& data);

/// Misses per query in each level of a machine, and the modelled memory time.
[[nodiscard]] TextGrid misses_grid(const ReportData& data, const std::string& machine);
/// Misses of one machine by level and cause, cold and warm.
[[nodiscard]] TextGrid causes_grid(const ReportData& data, const std::string& machine);
/// Returns the levels of a machine that have misses by field and step.
[[nodiscard]] std::vector<std::string> broken_down_levels(const ReportData& data, const std::string& machine);
inline constexpr store::FigureName misses_by_field("caches.{machine}.{level}.field.{field}"),
    misses_by_step("caches.{machine}.{level}.step.{step}");
/// Misses of one level by field read, or by step that read it.
[[nodiscard]] TextGrid breakdown_grid(const ReportData& data, const std::string& machine,
                                      const std::string& level, const store::FigureName& by);
/// Lines and pages: of a query, a frame, a body and the scene; knees; parts touched.
[[nodiscard]] TextGrid working_sets_grid(const ReportData& data);

/// One line per scene, algorithm and level: whether tree-PLRU or random replacement ranks the tables
/// otherwise.
[[nodiscard]] TextGrid policy_grid(const ReportData& data);

/// Support queries on a line per vertex next to those on separate arrays, and in one sentence what they say
/// of the published claim ("up to five times", arXiv 2509.03753).
[[nodiscard]] TextGrid support_grid(const ReportData& data);
[[nodiscard]] std::string support_verdict(const ReportData& data);

/// A cell of a table with seeds, or of one without, and the size of its seeds.
struct SeededCell {
    const ReportCell* cell;
    std::string starts;  ///< how its queries start: "cold", "random orientation"
    double seed_bytes;
};
/// Returns the cells of scenes and shapes that have tables with seeds and one without, by scene, vertices,
/// algorithm and bytes.
[[nodiscard]] std::vector<SeededCell> seeded_cells(const ReportData& data);
/// Returns time, steps and lines of the cells of seeded_cells.
[[nodiscard]] TextGrid seeds_grid(const ReportData& data);

/// Cells of one scene, by shape and then fastest first.
[[nodiscard]] TextGrid time_grid(const ReportData& data, const std::string& scene_label, PairKind kind);

/// Returns the libraries: version, query, what a pair keeps, flags.
[[nodiscard]] TextGrid peers_grid(const ReportData& data);
/// Returns Edgewise and other libraries in one scene, with time and error: by shape, fastest first.
[[nodiscard]] TextGrid peer_grid(const ReportData& data, const std::string& scene_label);

/// Returns the cells on a Pareto front of time and error, by scene and shape, fastest first; an empty `shape`
/// means all.
[[nodiscard]] TextGrid front_grid(const ReportData& data, const std::string& shape);
/// Returns the timed cells that are not among the points, and why.
[[nodiscard]] TextGrid left_out_grid(const ReportData& data);

/// Returns what a query takes in Edgewise and in other libraries, by scene and shape, fewest instructions
/// first.
[[nodiscard]] TextGrid effort_grid(const ReportData& data);
/// Returns the floor of each row of effort_grid, and what was spent over it.
[[nodiscard]] TextGrid effort_floor_grid(const ReportData& data);

/// Worst errors and sums by algorithm and table type, over all cells.
[[nodiscard]] TextGrid error_summary_grid(const ReportData& data);
/// The error figures of every cell.
[[nodiscard]] TextGrid error_grid(const ReportData& data);

/// The stability run, all families together: one row per algorithm and table type.
[[nodiscard]] TextGrid stability_summary_grid(const ReportData& data);
/// One row per family x algorithm and table type.
[[nodiscard]] TextGrid stability_grid(const ReportData& data);

/// Scene labels in order.
[[nodiscard]] std::vector<std::string> scene_labels(const ReportData& data);
/// The sweep's bodies with their vertices: by these, then by name.
[[nodiscard]] std::vector<std::pair<std::int64_t, std::string>> shapes_by_vertices(const ReportData& data);

// The interval of a median ratio over rounds or processes, by order statistics: no distribution is assumed
// and no random number drawn, so the same store gives the same report. With fewer than six ratios the whole
// range holds the median with less than 95 %; the interval then is that range and says so.

struct RatioInterval {
    double low = 0, high = 0;
    bool whole_range = false;  ///< too few ratios for 95 %
};

/// Null when there are fewer than two ratios.
[[nodiscard]] std::optional<RatioInterval> median_interval(std::vector<double> ratios);

// Which fields of a table's records travel together, as the fields run stored it: what was advised, what it
// was predicted to save, and what became of that when a table was built so.

/// One row per table and algorithm: lines before, predicted and counted, misses, times, verdicts.
[[nodiscard]] TextGrid field_advice_grid(const ReportData& data);
/// The advised records of one row, next to the records of the table.
[[nodiscard]] TextGrid field_groups_grid(const ReportCell& row);
/// Says in one sentence how often advice held in lines and in time, over all rows.
[[nodiscard]] std::string field_verdict(const ReportData& data);

/// Which fields of one row are read together, as an SVG: a matrix of squares, above the diagonal by the same
/// query, below it by the same step. One colour, the more of it the more often, and text in the colour of its
/// surroundings: it reads on white and on black. Fields of one record are adjacent and framed.
[[nodiscard]] std::string field_picture(const ReportCell& row);

// Times next to errors, panel by panel: the cells of one scene and shape that answer the same question, ours
// and other libraries', and which of them are on the Pareto front of time and error: those that nothing beats
// in both. A point is dominated by one that is no worse in either and better in one, so equal points are on
// the front together or not at all. Table and chart show the same.

/// Smaller is better in both; infinity is a number, NaN none.
struct SpeedError {
    double ns, error;
};

/// The error of a point that takes no part: a point with a NaN is on no front and dominates none.
inline constexpr double on_no_front = std::numeric_limits<double>::quiet_NaN();

/// Returns true for each point that no point dominates.
[[nodiscard]] std::vector<bool> pareto_front(std::span<const SpeedError> points);

/// One way to sum up a cell's errors.
struct ErrorKind {
    std::string_view id, title;
    store::FigureName figure;
};
inline constexpr ErrorKind error_kinds[] = {{"p50", "p50", "error.p50_error_given"},
                                            {"p999", "p99.9", "error.p999_error_given"},
                                            {"worst", "worst", "error.worst_error_given"}};
inline constexpr std::size_t error_kind_count = std::size(error_kinds);

struct FrontPoint {
    const ReportCell* cell;
    double ns;                                                   ///< per query, separated pairs; above 0
    std::array<std::optional<double>, error_kind_count> errors;  ///< over the scale of the pair; one at least
    std::array<bool, error_kind_count> on_front;                 ///< of this time and that error

    [[nodiscard]] bool on_any_front() const;
};

struct FrontPanel {
    std::string scene_label, shape;
    std::int64_t vertices;
    std::vector<FrontPoint> points;  ///< fastest first
};

struct Fronts {
    std::vector<FrontPanel> panels;  ///< by scene as in scene_labels, then vertices and shape
    std::vector<std::pair<const ReportCell*, std::string>>
        left_out;  ///< timed cells without a place, and why
};

/// Returns the fronts over all timed cells. The data must outlive the result.
[[nodiscard]] Fronts fronts_of(const ReportData& data);

}  // namespace edgewise::reports
