// SPDX-License-Identifier: MIT
//
// Runs one cell of a group that shares its queries: builds it, answers the queries, checks the answers, then
// times it round by round and measures it with every probe.
#pragma once

#include <string>
#include <vector>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/trace/touched_tables.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/prepared_cell.hpp"

namespace edgewise::sweep {

// A store keeps two texts for pictures of heat on the body: each body once, and for each cell how often its
// scene read each feature of the body.

/// {"vertices": [x, y, z, ...], "edges": [tail, head, ...], "faces": [[vertex, ...], ...]}
[[nodiscard]] std::string body_json(const Polyhedron& body);

/// {"queries": n, "vertices": [reads, ...], "edges": ..., "faces": ...}, in the body's order; null for a kind
/// of feature that has no bytes of its own in the layout.
[[nodiscard]] std::string heat_json(const bench::FeatureHeat& heat);

/// Returns true if a picture of the body can show the heat of this table type: it numbers features as the
/// body does, it is the layout's type in double precision, and the body has few enough vertices.
[[nodiscard]] bool shows_heat(const bench::TableType& type, std::int64_t vertices);

class CellRun {
  public:
    /// `row` describes the cell, except for layout, algorithm and axes; `body` is the shape of its scene.
    CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes, store::CellRow row,
            const Polyhedron& body);

    /// Marks the cell as one that does not run, with the reason.
    void make_unavailable(const std::string& reason);

    /// Orders a model of the cell's caches. The machines must outlive the cell.
    void model_caches(const bench::CacheOrder& caches) { caches_ = caches; }
    [[nodiscard]] const bench::CacheOrder& caches() const { return caches_; }

    /// Restricts the measurement to these probes. The names must outlive the cell.
    void measure_only(std::span<const std::string> probes) { only_ = probes; }

    /// Builds the tables, answers every query, checks the sample. Sets the row's status and reason. The
    /// functions below do nothing before this call, and nothing for a cell that is unavailable.
    void verify(SharedQueries& shared);

    [[nodiscard]] bool verified() const { return row_.verified(); }
    /// Returns true for a verified cell and for a peer's cell: both kinds are timed.
    [[nodiscard]] bool is_timed() const { return row_.is_timed(); }
    [[nodiscard]] const store::CellRow& row() const { return row_; }

    /// Times one pass. Times nothing if the cell is unavailable.
    [[nodiscard]] measure::Timing time(double clock_cost_ns) const { return cell_.time(clock_cost_ns); }

    enum class Stage { beside_others, alone };
    /// Measures the cell with the probes of one stage: `beside_others` has the probes that may run for
    /// several cells at a time, `alone` the rest. The cell fails if a pass does not repeat the first answers.
    void measure(Stage stage, std::span<const measure::Round> rounds);

    /// Returns heat_json of the cell: how often the traced queries read each feature of the body. Empty if
    /// the cell's caches are not modelled, or if shows_heat is false.
    [[nodiscard]] std::string heat_on_body() const;

    /// Figures that the probes measured.
    [[nodiscard]] const std::vector<store::FigureRow>& figures() const { return figures_; }

  private:
    /// Fails the cell if a later pass did not give the answers of the first.
    void hold_against_answers(const bench::PassSum& sum, std::string_view probe);

    PreparedCell cell_;
    Axes axes_;
    store::CellRow row_;
    const SharedQueries* shared_ = nullptr;  ///< null until the cell has run
    bench::CacheOrder caches_;
    std::span<const std::string> only_;  ///< empty: all probes
    std::vector<store::FigureRow> figures_;
};

}  // namespace edgewise::sweep
