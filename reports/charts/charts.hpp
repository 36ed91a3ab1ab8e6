// SPDX-License-Identifier: MIT
//
// The charts, as declarative Vega-Lite specifications (plain JSON, expressions included) plus what a page
// needs around them. This header has the shared parts (colours, legends, opacity, limits), so that a
// layout has one colour everywhere and a click on a legend means the same in every chart.
//
// Chart specifications as files. A *.vl.json file holds all of a chart but its data: title, how to read it,
// and a Vega-Lite specification in which "$name" is replaced by a value: a slot that the code fills, a part
// of the same file, or a part that all charts share (shared.vl.json). A slot's value is data and is never
// read as a name.
//
//   "$name"                    the value of that name; "$absent" leaves its member out
//   "$*name"      in a list    each item of that value
//   {"$let": {...}, ...}       these parts are known inside
//   {"$with": "$name", ...}    the members of that value, then these in their place
// in a list: one item for each of that list; the item's members are slots in it
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// Members keep the order in which they were added: the specifications stay readable.
using ChartJson = nlohmann::ordered_json;

/// The specification of a chart file, filled; throws std::out_of_range at a name that nothing has.
[[nodiscard]] ChartJson fill_spec(const ChartJson& file, const ChartJson& slots);

struct Chart {
    std::string name;  ///< of its file and its element: "bytes"
    std::string title;
    std::string how_to_read;                ///< two or three sentences
    ChartJson spec = {};                    ///< null when there is nothing to draw
    std::vector<std::string> notes = {};    ///< what is not drawn, and why
    TextGrid fallback = {};                 ///< the data as a small table, where no picture can be shown
    std::string section = {};               ///< of the chapter that shows it
    ChartJson file = {};                    ///< what its file says
    ChartJson points = ChartJson::array();  ///< the rows that it draws
    bool is_cited = false;                  ///< comes as PDF and CSV too (write_cited_figures)
};

[[nodiscard]] Chart bytes_chart(const ReportData& data);
[[nodiscard]] Chart time_chart(const ReportData& data);
[[nodiscard]] Chart speed_error_chart(const ReportData& data);
[[nodiscard]] Chart misses_chart(const ReportData& data);
[[nodiscard]] Chart seeds_chart(const ReportData& data);
[[nodiscard]] Chart tolerance_chart(const ReportData& data);
[[nodiscard]] std::vector<Chart> all_charts(const ReportData& data);

/// The most marks one chart may hold; browsers draw this many in about half a second. A chart that draws a
/// row more than once names fewer rows in its file.
inline constexpr std::size_t mark_limit = 20000;

/// Counts omitted values by reason, and writes one note for each reason.
class Omissions {
  public:
    void add(const std::string& reason) { ++counts_[reason]; }
    /// Returns the number if a logarithmic axis can show it; else null, and counts the reason, after `what`.
    [[nodiscard]] std::optional<double> positive(const measure::Figure& figure, const char* when_zero,
                                                 const std::string& what = {});
    void write(const std::string& noun, std::vector<std::string>& notes) const;

  private:
    nlohmann::ordered_map<std::string, std::size_t> counts_;
};
/// A chart's data while they are collected, and the reasons for values that are missing.
struct ChartRows {
    ChartJson values = ChartJson::array();
    Omissions omitted = {};
};
/// The chart that NAME.vl.json describes, without data.
[[nodiscard]] Chart chart_of_file(const std::string& name);
/// Sets the rows of its fallback table, thins them, notes what was left out (`noun`: of what there was none
/// to draw); false when no row is left.
[[nodiscard]] bool take_rows(Chart& chart, ChartRows& rows, const std::string& noun = "cell");
/// Fills its specification: `slots`, the rows as $values, and the orders and colours of what the data holds.
void draw(Chart& chart, const ReportData& data, const ChartJson& values,
          const ChartJson& slots = ChartJson::object());
/// Returns the chart with these rows drawn, if there are any.
[[nodiscard]] Chart drawn_chart(Chart chart, const ReportData& data, ChartRows rows,
                                const ChartJson& slots = ChartJson::object(),
                                const std::string& noun = "cell");

/// Returns the members that name a cell in every chart's data.
[[nodiscard]] ChartJson cell_json(const ReportCell& cell);
/// Adds a row: the members that name it, then others.
inline void add_point(ChartJson& values, ChartJson named, const ChartJson& others) {
    named.update(others);
    values.push_back(std::move(named));
}
/// Adds a time and its interval; both ends equal the time if no interval is stored.
void add_time(ChartJson& row, const ReportCell& cell, const store::QueryTime& time);
/// Which queries a chart is about: all, or those that start warm.
enum class Starts { all, warm };
/// Adds a row like `named` for each size of a cache for which the cell's misses are stored.
void add_misses(const ReportCell& cell, const ChartJson& named, Starts starts, ChartJson& values);
/// Colours by layout, shapes by algorithm, dashes by precision, each from a fixed order of names, whatever
/// else is shown or hidden; of curves also dashes by variant and shapes by point (charts.hpp).
[[nodiscard]] ChartJson order_slots(const ReportData& data, const ChartJson& values);
/// The scenes that the rows have, in the order of the data.
[[nodiscard]] ChartJson scenes_of_rows(const ReportData& data, const ChartJson& values);
/// Returns the slots of a choice of scenes: at least one scene; the last scene is in view first.
[[nodiscard]] ChartJson scene_slots(const ChartJson& scenes);
/// Algorithms in the order of all charts.
[[nodiscard]] std::vector<std::string> algorithm_names(const ReportData& data);
/// Keeps every k-th row so that at most `rows` stay; says so in a note.
void thin(ChartJson& values, std::size_t rows, std::vector<std::string>& notes);
/// The first rows of a chart's data under the given fields.
[[nodiscard]] TextGrid data_grid(const ChartJson& values, const std::vector<std::string>& fields);

// A chart of curves over one number of a scene: one curve per algorithm and table type, with its interval
// behind it. Colour is the layout, dash what else makes the table type (precision, further axes), point shape
// the algorithm. Its layers are the part "curves" of shared.vl.json: the interval layer comes first and holds
// the layout's parameter, since a composite error bar in its place would swallow legend clicks without a
// word.

/// Returns the members that name a cell among curves: those of cell_json, and `variant`, `point`, `stroke`. A
/// row that sets `unjoined` is a point that no line goes through; one that sets `larger` is a larger one.
[[nodiscard]] ChartJson curve_json(const ReportCell& cell);
/// A row with the time of all pairs and its interval in `ns`, `low`, `high`; null, and counted, when it was
/// not measured.
[[nodiscard]] ChartJson timed_row(const ReportCell& cell, Omissions& omitted);

/// Adds a timed row with the members of `place` for each cell; a cell is left out if its `place` is null.
template <class Place>
void add_timed_rows(ChartRows& rows, const std::vector<const ReportCell*>& cells, const Place& place) {
    for (const ReportCell* cell : cells) {
        const ChartJson more = place(*cell);
        if (more.is_null()) continue;
        ChartJson row = timed_row(*cell, rows.omitted);
        if (row.is_null()) continue;
        add_point(rows.values, std::move(row), more);
    }
}

// A logarithmic axis of errors. An error of exactly 0 has no place on it, so it is drawn on a labelled floor,
// a whole power of ten that is a decade or more below the smallest error.

class ErrorAxis {
  public:
    /// Errors that it must show, in any order, none below 0; one at least.
    explicit ErrorAxis(std::vector<double> errors);

    /// Returns the place on the axis at which an error of 0 is drawn.
    [[nodiscard]] double floor() const { return floor_; }
    [[nodiscard]] bool has_zeros() const { return errors_.front() == 0; }
    [[nodiscard]] double place(double error) const { return error > 0 ? error : floor_; }
    /// Returns even powers of ten among the errors, and the floor if an error of 0 exists. A tick beyond the
    /// data would be drawn outside the panel.
    [[nodiscard]] ChartJson ticks() const;
    /// First and last place.
    [[nodiscard]] ChartJson domain() const;
    /// A Vega expression of a tick's label.
    [[nodiscard]] std::string tick_label() const;

  private:
    std::vector<double> errors_;  ///< in order
    double floor_ = 1e-15;
};

}  // namespace edgewise::reports
