// SPDX-License-Identifier: MIT
//
// One cell among those that share its queries: built, answered and checked, then timed round by round and
// measured by every probe.
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

// What a store keeps for pictures of heat on the body itself: each body once, and how often the scene of a
// cell read each of its features.

/// {"vertices": [x, y, z, ...], "edges": [tail, head, ...], "faces": [[vertex, ...], ...]}
[[nodiscard]] std::string body_json(const Polyhedron& body);

/// {"queries": n, "vertices": [reads, ...], "edges": ..., "faces": ...}, in the body's order; null where the
/// layout stores nothing for these alone.
[[nodiscard]] std::string heat_json(const bench::FeatureHeat& heat);

/// Whether a table type's order of features is the body's, and its heat stands for its layout's (of one
/// precision each); of bodies that a picture can show.
[[nodiscard]] bool shows_heat(const bench::TableType& type, std::int64_t vertices);

class CellRun {
  public:
    /// `row` says what the cell is of, but for layout, algorithm and axes; `body` is its scene's shape.
    CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes, store::CellRow row,
            const Polyhedron& body);

    /// For a cell that is not to be run.
    void make_unavailable(const std::string& reason);

    /// For a cell whose caches are to be modelled; the machines must stay.
    void model_caches(const bench::CacheOrder& caches) { caches_ = caches; }
    [[nodiscard]] const bench::CacheOrder& caches() const { return caches_; }

    /// For a cell that is to be measured by these probes alone; the names must stay.
    void measure_only(std::span<const std::string> probes) { only_ = probes; }

    /// Builds the tables, answers every query, checks the sample. Sets the row's status and reason. What
    /// follows does nothing before that, nor for a cell that is unavailable.
    void verify(SharedQueries& shared);

    [[nodiscard]] bool verified() const { return row_.verified(); }
    /// Verified, or a peer's: those are timed.
    [[nodiscard]] bool is_timed() const { return row_.is_timed(); }
    [[nodiscard]] const store::CellRow& row() const { return row_; }

    /// One timed pass; of a cell that is unavailable nothing.
    [[nodiscard]] measure::Timing time(double clock_cost_ns) const { return cell_.time(clock_cost_ns); }

    enum class Stage { beside_others, alone };
    /// Lets the probes of that stage measure the cell: those that several cells may be measured by at a time,
    /// or the others. A pass whose answers differ from the first fails the cell.
    void measure(Stage stage, std::span<const measure::Round> rounds);

    /// How often the queries whose caches are modelled read each feature of the body, as heat_json has
    /// it; empty of other cells, and of those that it does not show.
    [[nodiscard]] std::string heat_on_body() const;

    /// What the probes have measured.
    [[nodiscard]] const std::vector<store::FigureRow>& figures() const { return figures_; }

  private:
    /// Whether another pass gave the answers of the first; fails the cell if not.
    void hold_against_answers(const bench::PassSum& sum, std::string_view probe);

    PreparedCell cell_;
    Axes axes_;
    store::CellRow row_;
    const SharedQueries* shared_ = nullptr;  ///< when the cell has run
    bench::CacheOrder caches_;
    std::span<const std::string> only_;  ///< none: by all probes
    std::vector<store::FigureRow> figures_;
};

}  // namespace edgewise::sweep
