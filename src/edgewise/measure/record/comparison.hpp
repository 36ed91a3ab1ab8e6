// SPDX-License-Identifier: MIT
//
// An old record of figures against a new one, row by row. Every use of records, `edgewise compare`, `lock`,
// `bench gate`, `report --compare` and `report claims --diff`, has this comparison, its text, its JSON and
// its exit code.
//
// A figure with an interval is worse where the whole interval lies above the old one's by more than the
// slack: noise widens intervals, and a difference inside them is no regression. An exact figure is worse
// where it grew at all. In a record without slack every difference counts. Limits of the old record come
// before both rules.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/measure/record/record.hpp"

namespace edgewise::measure {

enum class Outcome : std::uint8_t {
    over,  ///< above the hard limit
    worse,
    changed,  ///< of a word, or of a figure that must stay the same
    missing,  ///< only the old record has it
    added,    ///< only the new record has it
    better,
    within,  ///< a difference that intervals, slack and limits allow
    equal,
};

struct ComparedRow {
    RecordRow was, is;  ///< both named; one is without value where the row is missing or new
    Outcome outcome = Outcome::equal;
    std::string note = {};  ///< what explains it

    [[nodiscard]] double change() const { return was.value > 0 ? is.value / was.value : 0; }
    /// The widest interval of the change that both intervals allow.
    [[nodiscard]] double least_change() const { return was.high > 0 ? is.low / was.high : 0; }
    [[nodiscard]] double most_change() const { return was.low > 0 ? is.high / was.low : 0; }
};

/// Machine or build of either record.
struct ComparedCondition {
    std::string what, was, is;
    [[nodiscard]] bool same() const { return was == is; }
};

struct RecordComparison {
    bool must_stay = false;         ///< the old record has no slack
    std::vector<ComparedRow> rows;  ///< by outcome; the largest least change first where there is slack
    std::vector<ComparedCondition> conditions;
    std::vector<std::string> faults = {};  ///< why it fails whatever the rows are, one line each

    [[nodiscard]] std::size_t count(Outcome outcome) const;
    [[nodiscard]] std::size_t compared() const;  ///< rows that both records have
    /// Returns true for a row that is over, worse or changed, and for one that must stay and is missing or
    /// new.
    [[nodiscard]] bool fails(const ComparedRow& row) const;
    /// Returns true if there is no fault, something was compared, and no row fails.
    [[nodiscard]] bool passed() const;
    /// 3 if a figure is over its hard limit, else 1 if it did not pass.
    [[nodiscard]] int exit_code() const;
};

/// Compares two records, with the slack of the old record. A cell that is in one record only gets one row.
[[nodiscard]] RecordComparison compare(const FigureRecord& was, const FigureRecord& is);

/// A line for each row that differs, worst first, then conditions, and at the end what was found. `old_name`:
/// the old record's file.
[[nodiscard]] std::string to_text(const RecordComparison& comparison, const std::string& old_name);

/// The line of one row, and its note as a second one.
[[nodiscard]] std::string to_text(const ComparedRow& row);

/// {"passed", "compared", "worse": n, ..., "rows": [{"outcome", "cell", "figure", "was", "is", "note"}],
/// "conditions": [{"what", "was", "is"}], "faults"} in one line; a value with an interval is [low, value,
/// high], and rows that are equal are left out.
[[nodiscard]] std::string to_json(const RecordComparison& comparison);

}  // namespace edgewise::measure
