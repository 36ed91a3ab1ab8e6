// SPDX-License-Identifier: MIT
//
// One cell at work within its group: built, answered, checked, timed round by round, and made into figures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/cell.hpp"
#include "edgewise/sweep/group.hpp"
#include "edgewise/sweep/registry.hpp"
#include "edgewise/sweep/store.hpp"
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

    /// Builds the tables, answers every query, checks the sample. Sets the row's status and reason.
    void verify(Group& group);

    [[nodiscard]] bool verified() const { return row_.status == "verified"; }
    [[nodiscard]] const CellRow& row() const { return row_; }

    /// One timed pass; only for verified cells.
    [[nodiscard]] Timing time(const Group& group, double clock_cost_ns) const;

    /// What every probe makes of this cell; an unverified cell has no figures.
    [[nodiscard]] std::vector<FigureRow> figures(SizeFamily& sizes, std::span<const Round> rounds) const;

  private:
    const TableType& type_;
    Axes axes_;
    CellRow row_;
    std::unique_ptr<Runner> runner_;
    std::vector<std::uint8_t> in_contact_;
    std::vector<CheckedAnswer> checked_;
    AnswerCounts counts_;
    LinesTouched touched_;
};

}  // namespace edgewise
