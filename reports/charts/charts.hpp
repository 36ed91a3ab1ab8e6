// SPDX-License-Identifier: MIT
//
// The charts, as declarative Vega-Lite specifications (plain JSON, expressions included) plus what a page
// needs around them. One file a chart; what they share (colours, legends, opacity, limits) is here, so that a
// layout has one colour everywhere and a click on a legend means the same in every chart.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// Members keep the order in which they were added: the specifications stay readable.
using ChartJson = nlohmann::ordered_json;

struct Chart {
    std::string name;  ///< of its file and its element: "bytes"
    std::string title;
    std::string how_to_read;         ///< two or three sentences
    ChartJson spec;                  ///< null when there is nothing to draw
    std::vector<std::string> notes;  ///< what is not drawn, and why
    TextGrid fallback;               ///< the data as a small table, where no picture can be shown
    std::string section = {};  ///< of the chapter on the paper's figures; empty: among the page's charts
    ChartJson file = {};       ///< what its file says (spec_file.hpp)
};

[[nodiscard]] Chart bytes_chart(const ReportData& data);
[[nodiscard]] Chart time_chart(const ReportData& data);
[[nodiscard]] Chart speed_error_chart(const ReportData& data);
[[nodiscard]] Chart misses_chart(const ReportData& data);
[[nodiscard]] Chart ratio_chart(const ReportData& data);
[[nodiscard]] Chart tolerance_chart(const ReportData& data);
[[nodiscard]] Chart gap_chart(const ReportData& data);
[[nodiscard]] std::vector<Chart> all_charts(const ReportData& data);

/// The most marks one chart may hold; browsers draw this many in about half a second. A chart that draws a
/// row more than once names fewer rows in its file.
inline constexpr std::size_t mark_limit = 20000;

/// Counts what was left out by reason, and writes one note for each.
class Omissions {
  public:
    void add(const std::string& reason);
    void write(const std::string& noun, std::vector<std::string>& notes) const;

  private:
    std::vector<std::pair<std::string, std::size_t>> counts_;
};
/// The chart that NAME.vl.json describes, without data.
[[nodiscard]] Chart chart_of_file(const std::string& name);
/// Sets the rows of its fallback table, thins them, notes what was left out (`noun`: of what there was none
/// to draw); false when no row is left.
[[nodiscard]] bool take_rows(Chart& chart, ChartJson& values, const Omissions& omitted = {},
                             const std::string& noun = "cell");
/// Fills its specification: `slots`, the rows as $values, and the orders and colours of what the data holds.
void draw(Chart& chart, const ReportData& data, const ChartJson& values,
          const ChartJson& slots = ChartJson::object());

/// What names a cell in every chart's data.
[[nodiscard]] ChartJson cell_json(const ReportCell& cell);
/// One stored figure of a family of the stability run.
struct StabilityFigure {
    const ReportCell* row;
    std::string at;  ///< what its name has for the braces
    double value;
};
[[nodiscard]] std::vector<StabilityFigure> stability_figures(const ReportData& data,
                                                             const store::FigureName& family);
/// What names an algorithm on a table type.
[[nodiscard]] ChartJson table_json(const ReportData& data, const std::string& algorithm,
                                   const std::string& table);
/// Colours by layout, shapes by algorithm, dashes by precision, each from a fixed order of names, whatever
/// else is shown or hidden; of curves also dashes by variant and shapes by point (curves.hpp).
[[nodiscard]] ChartJson order_slots(const ReportData& data, const ChartJson& values);
/// Algorithms in the order of all charts.
[[nodiscard]] std::vector<std::string> algorithm_names(const ReportData& data);
/// Shapes by vertices, then name.
[[nodiscard]] std::vector<std::string> shapes_by_size(const ReportData& data);
/// Keeps every k-th row so that at most `rows` stay; says so in a note.
void thin(ChartJson& values, std::size_t rows, std::vector<std::string>& notes);
/// The first rows of a chart's data under the given fields.
[[nodiscard]] TextGrid data_grid(const ChartJson& values, const std::vector<std::string>& fields);

}  // namespace edgewise::reports
