// SPDX-License-Identifier: MIT
//
// One cell at work within its shared: built, answered, checked, timed round by round, and made into figures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/cache/scene_trace.hpp"
#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/shared_queries.hpp"
#include "edgewise/sweep/table_bytes.hpp"

namespace edgewise::sweep {

class CellRun {
  public:
    CellRun(const bench::TableType& type, std::string algorithm, const Axes& axes, store::CellRow row);

    /// Sets the row's hash; the cell's identity is complete from here on.
    void name(const Polyhedron& body) { bench::name_cell(row_, body); }

    void make_unavailable(const std::string& reason) {
        row_.status = "unavailable";
        row_.reason = reason;
    }

    /// For a cell whose caches are to be modelled; the machines must stay.
    void model_caches(std::span<const measure::MachineChoice> machines) { machines_ = machines; }
    [[nodiscard]] bool models_caches() const { return !machines_.empty(); }

    /// Builds the tables, answers every query, checks the sample. Sets the row's status and reason.
    void verify(SharedQueries& shared);

    /// After verify(): models the caches, if they are to be, over so many queries (0: all). Contenders of a
    /// shared may be traced at the same time. Answers that differ from the first fail the cell.
    void trace(const SharedQueries& shared, std::size_t queries);

    /// After verify(): what the processor and the kernel count of a pass. As above.
    void count(const SharedQueries& shared);

    /// After verify(): what a step of the scene costs by part, and what the algorithm does inside.
    void study(const SharedQueries& shared);

    [[nodiscard]] bool verified() const { return row_.status == "verified"; }
    [[nodiscard]] const store::CellRow& row() const { return row_; }

    /// One timed pass; only for verified cells.
    [[nodiscard]] measure::Timing time(const SharedQueries& shared, double clock_cost_ns) const;

    /// What every probe makes of this cell; an unverified cell has no figures.
    [[nodiscard]] std::vector<store::FigureRow> figures(const SharedQueries& shared, SizeFamily& sizes,
                                                        std::span<const measure::Round> rounds) const;

  private:
    /// Whether another pass gave the answers of the first; fails the cell if not.
    void hold_against_answers(const bench::PassSum& sum, const char* pass);

    const bench::TableType& type_;
    Axes axes_;
    store::CellRow row_;
    std::unique_ptr<bench::Runner> runner_;
    std::vector<std::uint8_t> in_contact_;
    std::vector<double> distances_;  ///< the answers' sums, query by query
    std::vector<measure::CheckedAnswer> checked_;
    measure::AnswerCounts counts_;
    measure::LinesTouched touched_;
    std::span<const measure::MachineChoice> machines_;
    measure::SceneTrace trace_;
    std::vector<measure::PassRecord> counted_;
    measure::StepCosts costs_;
    measure::AlgorithmWork work_;
};

}  // namespace edgewise::sweep
