// SPDX-License-Identifier: MIT
//
// One cell at work within its group: built, answered, checked, timed round by round, and made into figures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/cache/scene_trace.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/sweep/shared_queries.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/table_bytes.hpp"

namespace edgewise {

class Contender {
  public:
    Contender(const TableType& type, std::string algorithm, const Axes& axes, CellRow row);

    /// Sets the row's hash; the cell's identity is complete from here on.
    void name(const Polyhedron& body) { name_cell(row_, body); }

    void make_unavailable(const std::string& reason) {
        row_.status = "unavailable";
        row_.reason = reason;
    }

    /// For a cell whose caches are to be modelled; the machines must stay.
    void model_caches(std::span<const MachineChoice> machines) { machines_ = machines; }
    [[nodiscard]] bool models_caches() const { return !machines_.empty(); }

    /// Builds the tables, answers every query, checks the sample. Sets the row's status and reason.
    void verify(Group& group);

    /// After verify(): models the caches, if they are to be, over so many queries (0: all). Contenders of a
    /// group may be traced at the same time. Answers that differ from the first fail the cell.
    void trace(const Group& group, std::size_t queries);

    /// After verify(): what the processor and the kernel count of a pass. As above.
    void count(const Group& group);

    /// After verify(): what a step of the scene costs by part, and what the algorithm does inside.
    void study(const Group& group);

    [[nodiscard]] bool verified() const { return row_.status == "verified"; }
    [[nodiscard]] const CellRow& row() const { return row_; }

    /// One timed pass; only for verified cells.
    [[nodiscard]] Timing time(const Group& group, double clock_cost_ns) const;

    /// What every probe makes of this cell; an unverified cell has no figures.
    [[nodiscard]] std::vector<FigureRow> figures(const Group& group, SizeFamily& sizes,
                                                 std::span<const Round> rounds) const;

  private:
    /// Whether another pass gave the answers of the first; fails the cell if not.
    void hold_against_answers(const PassSum& sum, const char* pass);

    const TableType& type_;
    Axes axes_;
    CellRow row_;
    std::unique_ptr<Runner> runner_;
    std::vector<std::uint8_t> in_contact_;
    std::vector<double> distances_;  ///< the answers' sums, query by query
    std::vector<CheckedAnswer> checked_;
    AnswerCounts counts_;
    LinesTouched touched_;
    std::span<const MachineChoice> machines_;
    SceneTrace trace_;
    std::vector<PassRecord> counted_;
    StepCosts costs_;
    AlgorithmWork work_;
};

}  // namespace edgewise
