// SPDX-License-Identifier: MIT
//
// The interface of a study: a measurement next to a sweep's cells that a plan can ask for. A study is one
// folder of the room `studies`, where a source defines `Study NAME_study()`, and one line in
// studies/CMakeLists.txt. Plans, shards, progress, the store and the report know it from here.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/input/count.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/shard.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

/// Called for each row that is in the store: a name for progress, and the row's status.
using OnStudyRow = std::function<void(const std::string& what, store::CellStatus status)>;

/// A chapter of the report with one row for each row of the study. It is stored next to the rows, because the
/// report knows the store alone.
struct StudyChapter {
    struct Column {
        std::string figure;  ///< "probe.name", as stored
        std::string title;   ///< with the unit
        double unit = 1;     ///< by which the figure is divided
    };

    std::string title;  ///< empty: the report has a chapter of its own for this study
    std::string text;   ///< what the figures are and how to read them
    std::vector<Column> columns;
};

struct Study {
    /// The member of a plan that asks for the study, `run` of its rows, and the beginning of its units'
    /// names.
    std::string_view name;
    input::CountRange counts;  ///< what a plan may ask for; 0: nothing. Up to 1: true or false
    /// Returns the number of rows of this work; 0 if this program cannot make any.
    std::size_t (*rows)(const SweepWork& work);
    /// Returns the seconds of a row that are expected until a store has measured ones: those of two cores of
    /// one machine. They decide only what progress says and how even shards are.
    double (*seconds_each)(const SweepWork& work);
    /// Measures the rows that the store lacks and stores them. Returns false if it was stopped before the
    /// end.
    bool (*run)(const SweepWork& work, store::Store& store, const OnStudyRow& on_row,
                const std::atomic<bool>& stop);
    /// Names the parts that shards can run apart, each with equally many rows; null: it has none.
    std::vector<std::string> (*parts)() = nullptr;
    bool of_bodies = false;  ///< it measures the plan's bodies: mesh files are read for it
    StudyChapter chapter = {};
};

/// Returns every study of this program, in the order of the manifest studies/CMakeLists.txt.
[[nodiscard]] std::span<const Study> registered_studies();

/// Returns the name of a unit that one shard runs: "paging", or "stability parallel_faces" for a part of a
/// study. A store keeps the seconds of a unit under this name (store::took_key).
[[nodiscard]] std::string unit_name(std::string_view study, const std::string& part = {});

/// Returns true if the plan asks for the study and this program can run it.
[[nodiscard]] bool has_rows(const Study& study, const SweepWork& work);

/// Keeps only the shard's part of the work: of its comparisons and of the units of its studies. `seconds`:
/// what units took in an earlier run, or none.
void keep_shard(SweepWork& work, const Shard& shard, const std::map<std::string, double>& seconds);

/// Puts the study's chapter into the store, for the report.
void store_chapter(const Study& study, store::Store& store);

}  // namespace edgewise::sweep
