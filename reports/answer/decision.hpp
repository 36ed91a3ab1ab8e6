// SPDX-License-Identifier: MIT
//
// The decision table: for each body of a store what to take if all bodies share a table, and if each has its
// own. Page, report.md, the end of a sweep and `edgewise advise` show these texts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// One cell of the table.
struct Decision {
    std::string take;  ///< "V-Clip on lean_f32"; empty: nothing is recommended
    /// The time over the paper's layout, bytes, worst error, near contact and default flags; or why nothing
    /// is recommended.
    std::vector<std::string> facts;
    bool near_contact_changes_it = false, default_flags_change_it = false;

    /// Returns "take V-Clip on lean_f32: 0.72 [0.69, 0.83] of the time of the paper's layout; ...".
    [[nodiscard]] std::string text() const;
};

/// Returns the decision for the body of the answer.
[[nodiscard]] Decision decision_of(const Answer& answer, bool own_tables);

struct DecisionRow {
    std::string shape;
    std::int64_t vertices;
    Decision shared, own;
};

struct DecisionTable {
    std::vector<DecisionRow> rows;     ///< fewest vertices first
    std::string sentence;              ///< above the table
    std::vector<std::string> changes;  ///< below it: what would change it

    /// Returns the sentence and a line for each decision on the tables in question.
    [[nodiscard]] std::string text(const Question& question) const;
};

/// The largest allowed errors for which the page has answers.
inline constexpr double offered_limits[] = {1e-4, 1e-6, 1e-8, 1e-12};

/// The decisions of a store for the bodies and tables of a question, at its error limit and at those offered.
class Decisions {
  public:
    explicit Decisions(const ReportData& data, const Question& question = {});

    /// Returns the table for one of the limits; of one body if a shape is given.
    [[nodiscard]] DecisionTable table(double error_limit, const std::string& shape = {}) const;

  private:
    std::map<double, std::vector<DecisionRow>> by_limit_;
    std::vector<std::string> not_measured_;
};

}  // namespace edgewise::reports
