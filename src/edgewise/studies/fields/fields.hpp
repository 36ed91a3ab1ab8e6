// SPDX-License-Identifier: MIT
//
// Advice on a layout's records, and its outcome. From a trace of one cell: which fields are read
// together, and the groups for which its queries read the fewest lines (predicted by replaying the trace
// with the fields at their new places). Then the advised table is built, its answers are verified, its lines
// are counted and its queries timed: advice of this kind is often right about lines and wrong about time.
//
// Interleaved rounds time these tables: the table that was asked about; its own groups in the layout that
// takes groups at run time, the baseline of the advice, since both pay for run-time groups; that baseline
// once more: its ratio to itself is the noise; the advised groups; and a layout made by hand.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/studies/fields/field_trace.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

/// [a][b] and [b][a]: number of times that fields a and b were both read; [a][a]: that field a was read.
using FieldCounts = std::vector<std::vector<std::uint64_t>>;

/// Reads of two fields together. They may share a line only if a step reads both of the same record.
struct CoAccess {
    FieldCounts by_query;                  ///< queries
    FieldCounts by_step;                   ///< steps
    FieldCounts by_record;                 ///< records in steps; 0 for fields of different records
    std::uint64_t queries = 0, steps = 0;  ///< steps: those that read of a table

    /// Returns the share of the reads of a or b that read both (Jaccard); 0 if neither is read.
    [[nodiscard]] static double overlap(const FieldCounts& counts, std::size_t a, std::size_t b);
};

/// Counts which fields are read together. Reads before a query's first step form a step of their own. Fields
/// of a pair's two tables count as the same fields, but never share a record.
[[nodiscard]] CoAccess co_access(const FieldTrace& trace);

// Cost of a trace: distinct lines of tables per query, and the modelled misses of several machines in
// their steady state. Traces of tables that were built and of predicted tables are counted in the same
// way.

/// Misses of a level, per query of all queries.
struct LevelMissesPerQuery {
    std::string machine, level;
    double misses = 0;
};

struct TraceCost {
    std::uint64_t queries = 0, lines = 0, reads = 0;  ///< sums, of tables
    std::vector<LevelMissesPerQuery> misses;

    [[nodiscard]] double lines_per_query() const { return per_query(lines); }
    [[nodiscard]] double reads_per_query() const { return per_query(reads); }

  private:
    [[nodiscard]] double per_query(std::uint64_t sum) const {
        return queries == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(queries);
    }
};

/// A pass over all queries of a trace, as often as it is called.
using TracePass = std::function<void(measure::TraceListener& listener)>;

/// Runs two passes: the first fills caches and counts lines, the second counts misses.
[[nodiscard]] TraceCost cost_of(const TracePass& pass, std::span<const measure::CacheMachine> machines);

/// Default cell.
inline const CellChoice fields_cell = {
    .parameters = {{"rotation_step", 0.1}}, .queries = 2000, .checked = 200};

struct FieldsPlan {
    CellChoice cell = fields_cell;
    std::vector<std::string> machines = {"pentium3_coppermine", "zen5"};  ///< not the host: misses repeat
    std::string beside;       ///< a table type made by hand; empty: the usual one, or none
    std::string groups_file;  ///< groups to try instead of the advised ones
    int rounds = 25;
};

/// A table that was built, traced and timed.
struct FieldsContender {
    enum class Role { original, own_groups, control, advised, beside };

    Role role{};
    std::string table;                  ///< type
    std::optional<FieldGroups> groups;  ///< of a layout that takes them
    std::string wrong;                  ///< with its answers; empty: all are right
    TraceCost cost;
    double table_bytes = 0;  ///< of all tables
    std::vector<double> ns;  ///< per query, by round
};

[[nodiscard]] std::string_view to_string(FieldsContender::Role role);

/// Ratio of two times of the same round: the median with its 95 % interval over the rounds of one process.
/// Nothing if there are too few rounds.
struct TimeRatio {
    double low = 0, middle = 0, high = 0;
};

/// Outcome of an advice.
enum class Held {
    yes,
    no,
    within_noise,  ///< of time: the interval reaches 1 or the control's interval
};
[[nodiscard]] std::string_view to_string(Held held);

struct FieldsAdvice {
    std::string table, builder;  ///< type asked about, and the one that takes groups
    std::vector<RecordField> fields;
    CoAccess together;
    std::optional<FieldGroups> own;  ///< nothing: no records by groups give this table
    FieldGroups advised;
    TraceCost predicted;  ///< of the advised groups, before they were built
    /// Lines per query for unseen queries of the same scene, which the advice did not use: before and after.
    double unseen_lines = 0, unseen_lines_advised = 0;
    std::vector<FieldsContender> contenders;

    [[nodiscard]] const FieldsContender* find(FieldsContender::Role role) const;
    /// Returns the time of the first contender over the second; nothing if either is missing.
    [[nodiscard]] std::optional<TimeRatio> ratio(FieldsContender::Role above,
                                                 FieldsContender::Role below) const;
    /// Returns the role that the advice is compared with: its own groups, or else the table itself.
    [[nodiscard]] FieldsContender::Role baseline() const;

    [[nodiscard]] bool all_right() const;
    /// Held if the lines equal the prediction exactly and are fewer than before.
    [[nodiscard]] Held lines_held() const;
    /// Held if the advised table is faster than the baseline by more than the noise.
    [[nodiscard]] Held time_held() const;
};

[[nodiscard]] bool has_table_type(const std::string& name);

/// Returns the table type that builds the groups advised for this one.
[[nodiscard]] std::string builder_of(const bench::TableType& type);

/// Calls on_round after each round. Throws std::invalid_argument for a cell that cannot be made, a layout
/// without places of fields, or a program that was built without a layout that takes groups.
[[nodiscard]] FieldsAdvice advise_fields(const FieldsPlan& plan, const std::function<void()>& on_round);

/// Row of the store for an advice, without status, and its figures.
[[nodiscard]] store::CellRow fields_row(const CellChoice& choice);
[[nodiscard]] std::vector<store::FigureRow> fields_figures(const FieldsAdvice& advice);

}  // namespace edgewise::studies
