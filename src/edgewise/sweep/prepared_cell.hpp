// SPDX-License-Identifier: MIT
//
// A cell (an algorithm on a table type) that is ready to be timed: its tables are built, its answers checked.
// Also the order in which cells take turns, so that all are affected equally by changes in machine speed.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/trace/touched_tables.hpp"
#include "edgewise/bench/trace/walk.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::sweep {

// One scene on one shape: the queries that every cell of a comparison answers, and their exact answers. Exact
// answers depend on the bodies alone, so cells that store the same bodies share them.

class SharedQueries {
  public:
    /// A choice without a recording may name one. Throws std::invalid_argument when the scene cannot be made.
    SharedQueries(const Plan& plan, const SceneChoice& scene, const scene::NamedShape& shape);

    [[nodiscard]] const scene::Workload& workload() const { return workload_; }
    /// Returns what a recording leaves out (recorded_workload); else empty.
    [[nodiscard]] const std::string& note() const { return note_; }
    /// Returns the workload with every query cold: no query knows the last answer of its pair.
    [[nodiscard]] const scene::Workload& cold_workload();

    /// Positions of the checked queries, spread evenly over the workload.
    [[nodiscard]] const std::vector<std::size_t>& checked() const { return checked_; }

    /// Returns the checked queries between these bodies with exact distances, in the order of checked().
    [[nodiscard]] std::vector<truth::KnownPair>& known(std::span<const Polyhedron> bodies);

    /// Returns the answer of the paper's control (truth/moore_wilhelms.hpp) for each checked query: true in
    /// contact. Empty if the plan has no control. Of large bodies only some are asked; the rest is nothing.
    [[nodiscard]] const std::vector<std::optional<bool>>& control(std::span<const Polyhedron> bodies);

  private:
    bool asks_control_;
    scene::Workload workload_;
    std::string note_;
    std::optional<scene::Workload> cold_workload_;  ///< made by the first call of cold_workload()
    std::vector<std::size_t> checked_;
    std::map<std::string, std::vector<truth::KnownPair>> known_;  // by the bodies' fingerprint
    std::map<std::string, std::vector<std::optional<bool>>> control_;
};

using MarginOf = std::function<double(const scene::Query&)>;

/// Returns the checked answers of one cell. `stored`: the bodies that its tables hold. `eps`: the rounding
/// step of its arithmetic; it alone decides the allowed errors. `asked`: what the answers are to. `margin`:
/// where needs have one, or the sum of the radii, if `asked` has one (Runner::margin).
[[nodiscard]] std::vector<truth::CheckedAnswer> check_answers(SharedQueries& shared,
                                                              std::span<const Polyhedron> stored,
                                                              std::span<const Distance> answers, double eps,
                                                              const bench::RunnerOptions& asked = {},
                                                              const MarginOf& margin = {});

/// Returns what is wrong, with the first case as an example; empty if every checked answer is right.
[[nodiscard]] std::string what_is_wrong(const SharedQueries& shared,
                                        std::span<const truth::CheckedAnswer> checked, double eps);

/// `cold`: a flag per query, from cold_starts; empty for a scene without warm pairs: all queries are cold.
[[nodiscard]] bench::AnswerCounts count_answers(std::span<const Distance> answers,
                                                std::span<const std::uint8_t> cold = {});

class PreparedCell {
  public:
    PreparedCell(const bench::TableType& type, const std::string& algorithm,
                 const bench::RunnerOptions& options = {});
    PreparedCell(const bench::TableType& type, std::unique_ptr<bench::Runner> runner,
                 const bench::RunnerOptions& options);

    /// Builds the tables. Returns an error line if a body cannot be stored. The workload must outlive this.
    [[nodiscard]] std::string load(const scene::Workload& workload) {
        workload_ = &workload;
        return runner_->load(workload);
    }

    /// Answers every loaded query and checks the sample. `shared` must have the same queries.
    void check(SharedQueries& shared);

    [[nodiscard]] const bench::TableType& type() const { return *type_; }
    [[nodiscard]] const bench::Runner& runner() const { return *runner_; }
    [[nodiscard]] const scene::Workload& workload() const { return *workload_; }

    /// Results of check(): the checked answers, the error text (empty: all right), and counts of all answers.
    [[nodiscard]] const std::vector<truth::CheckedAnswer>& checked() const { return checked_; }
    [[nodiscard]] const std::string& wrong() const { return wrong_; }
    [[nodiscard]] const bench::AnswerCounts& counts() const { return counts_; }
    [[nodiscard]] double mean_steps() const {
        return static_cast<double>(counts_.steps) / static_cast<double>(counts_.queries);
    }
    /// Returns the sum of the distances of the first `queries` answers, added in order.
    [[nodiscard]] double distances(std::size_t queries) const {
        return queries > 0 ? distances_[queries - 1] : 0;
    }

    /// Times one pass. Queries in contact are timed separately if check() found any.
    [[nodiscard]] measure::Timing time(double clock_cost_ns) const {
        return runner_->time(in_contact_, clock_cost_ns);
    }

  private:
    const bench::TableType* type_;
    bench::RunnerOptions options_;
    std::unique_ptr<bench::Runner> runner_;
    const scene::Workload* workload_ = nullptr;
    std::vector<std::uint8_t> in_contact_;  ///< a flag per query; empty if answers do not say it
    std::vector<double> distances_;         ///< running sums of the answers' distances, query by query
    std::vector<truth::CheckedAnswer> checked_;
    std::string wrong_;
    bench::AnswerCounts counts_;
};

/// Calls `take(i)` once for each i below `count`, in an order drawn from the seed: the order of a round.
void take_turns(std::size_t count, std::uint64_t seed, const std::function<void(std::size_t)>& take);

// Runs one cell of a group that shares its queries: builds it, answers the queries, checks the answers, then
// times it round by round and measures it with every probe.

// A store keeps two texts for pictures of heat on the body: each body once, and for each cell how often its
// scene read each feature of the body.

/// {"vertices": [x, y, z, ...], "edges": [tail, head, ...], "faces": [[vertex, ...], ...]}
[[nodiscard]] std::string body_json(const Polyhedron& body);

class CellRun {
  public:
    /// `row` describes the cell, except for layout, algorithm and axes; `body` is the shape of its scene.
    CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes, store::CellRow row,
            const Polyhedron& body);

    /// Marks the cell as one that does not run, with the reason.
    void make_unavailable(const std::string& reason) {
        row_.status = store::CellStatus::unavailable;
        row_.reason = reason;
    }

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
