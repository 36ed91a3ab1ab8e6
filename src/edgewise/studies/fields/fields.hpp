// SPDX-License-Identifier: MIT
//
// Which fields of a table's records are read together, and where they should lie: a trace of their reads, the
// search for the best groups, and the advice with its outcome.
//
// The trace keeps accesses to tables as fields of records, not as addresses: the field and the edge that were
// read. It can be replayed as if the fields lay elsewhere.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/trace_extent.hpp"
#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/table/field_map.hpp"

namespace edgewise::studies {

/// One access to a field of a table's record.
struct FieldAccess {
    std::uint32_t table = 0, element = 0;
    std::uint8_t field = 0, part = 0;  ///< as in FieldPlace

    [[nodiscard]] bool operator==(const FieldAccess&) const = default;
};

/// One event of a trace.
struct FieldEvent {
    enum class Kind : std::uint8_t { query_start, step_start, field, other, query_end, frame_end };

    Kind kind = Kind::frame_end;
    measure::QueryStart start{};     ///< of a query's start
    bool counts = false;             ///< of a query's end
    FieldAccess field = {};          ///< of a field
    measure::TracedAccess access{};  ///< of an access: as it was; of a step's start, its step
};

struct FieldTrace {
    std::vector<FieldMap> tables;
    std::vector<FieldEvent> events;
    std::uint64_t taken = 0;  ///< bytes of memory from the first table's start to the last one's end
    std::uint64_t queries = 0;

    [[nodiscard]] const std::vector<RecordField>& fields() const { return tables.front().fields; }
};

/// Traces a runner with a loaded workload. Throws std::invalid_argument if its layout does not say where its
/// fields lie, or if the runner reads memory that is no field.
[[nodiscard]] FieldTrace trace_fields(const bench::Runner& runner, const bench::TraceExtent& extent,
                                      const std::string& table);

// Replays a trace as if its tables' fields lay elsewhere, access by access in the same order: the reads of
// the same queries on a table with other records. They are computed from the groups alone; the reads of a
// table that was really built this way are traced separately.

/// Records by groups in one block a table, the tables one after another in an arena: the layout `grouped`.
class GroupedPlaces {
  public:
    GroupedPlaces(const std::vector<FieldMap>& tables, const FieldGroups& groups);

    /// Returns the address of the field.
    [[nodiscard]] std::uint64_t address(const FieldAccess& field) const {
        const Column& column = columns_[field.table][field.field];
        return column.first + field.element * column.stride + field.part;
    }

    /// Bytes from the first table's start to the last one's end.
    [[nodiscard]] std::uint64_t taken() const { return taken_; }

  private:
    struct Column {
        std::uint64_t first = 0, stride = 0;
    };
    std::vector<std::vector<Column>> columns_;  ///< by table and field
    std::uint64_t taken_ = 0;
};

/// Replays the trace. Everything behind the tables (pairs' caches, the broad phase) moves with their end.
void replay(const FieldTrace& trace, const GroupedPlaces& places, measure::TraceListener& listener);

// Finds the groups of fields for which a trace's queries read the fewest lines: an exact search, not a rule
// of thumb. A group is an array of records, and arrays begin on lines of their own, so one group's cost does
// not depend on the others; the best way to part n fields into groups then follows from the cost of each of
// their 2^n - 1 sets (dynamic programming over sets). Only the order of fields within a group, where it
// decides which of them share a line, is found by exchanging two at a time.
//
// Vertical partitioning by affinity (Navathe et al., 1984; Chilimbi, Davidson and Larus, 1999, for
// structures) takes the counts of CoAccess for a model of the cost. We count the lines themselves.

/// Number of queries that the search reads: the first ones of the trace.
inline constexpr std::uint64_t searched_queries = 2000;

/// Returns the best groups. Fields that no query reads form a group of their own, one for each kind of
/// record. Among equal numbers of lines fewer bytes win, then fewer groups.
[[nodiscard]] FieldGroups best_groups(const FieldTrace& trace);

/// Returns the groups that a table has now; nothing if fields of its records do not follow each other at one
/// distance, or are scattered scalar by scalar.
[[nodiscard]] std::optional<FieldGroups> groups_of(const FieldMap& map);

// Groups of fields as JSON for files: {"groups": [["tail_plane", "head_plane"], ["direction"]]}.

[[nodiscard]] nlohmann::json groups_json(const FieldGroups& groups, std::span<const RecordField> fields);

/// Reads a file in the format of groups_json, with every field once and one kind of record per group.
/// Throws std::invalid_argument: file, what is wrong, which groups are expected.
[[nodiscard]] FieldGroups read_groups(const std::string& file, std::span<const RecordField> fields);

// Advice on a layout's records, and its outcome. From a trace of one cell: which fields are read
// together, and the groups for which its queries read the fewest lines (predicted by replaying the trace
// with the fields at their new places). Then the advised table is built, its answers are verified, its lines
// are counted and its queries timed: advice of this kind is often right about lines and wrong about time.
//
// Interleaved rounds time these tables: the table that was asked about; its own groups in the layout that
// takes groups at run time, the baseline of the advice, since both pay for run-time groups; that baseline
// once more: its ratio to itself is the noise; the advised groups; and a layout made by hand.

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

/// Returns the table type that builds the groups advised for this one.
[[nodiscard]] std::string builder_of(const bench::TableType& type);

/// Calls on_round after each round. Throws std::invalid_argument for a cell that cannot be made, a layout
/// without places of fields, or a program that was built without a layout that takes groups.
[[nodiscard]] FieldsAdvice advise_fields(const FieldsPlan& plan, const std::function<void()>& on_round);

/// Row of the store for an advice, without status, and its figures.
[[nodiscard]] store::CellRow fields_row(const CellChoice& choice);
[[nodiscard]] std::vector<store::FigureRow> fields_figures(const FieldsAdvice& advice);

}  // namespace edgewise::studies
