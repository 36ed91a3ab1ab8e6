// SPDX-License-Identifier: MIT
//
// A first look at every algorithm on every table type for one case: is it right, how exact, how large, and
// roughly how fast. Short, in this process, without a word on how sure: it only says who need not be looked
// at again.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/studies/advise/case_asked.hpp"

namespace edgewise::studies::advise {

/// What a cell is out of question for; the first that applies.
enum class OutFor {
    nothing,
    failure,  ///< its tables cannot hold the body, or an answer is wrong
    error,    ///< right, and not as exact as was asked
    time,     ///< and slow is all that is wrong with it
};

struct ScreenedCell {
    const bench::TableType* type = nullptr;
    std::string algorithm;
    double bytes_per_edge = 0, table_bytes = 0;
    double error = 0;    ///< worst of the checked answers against the bodies as given, divided by the scale
    double ns = 0;       ///< per query, the shortest pass
    double steps = 0;    ///< per query
    double seconds = 0;  ///< that the look took, without its passes: tables, answers, checks
    OutFor out_for = OutFor::nothing;
    std::string out;  ///< why, in words; empty: it is not out

    [[nodiscard]] bool is_in() const { return out_for == OutFor::nothing; }
    [[nodiscard]] bool is_baseline() const;
    [[nodiscard]] std::string name() const;  ///< "V-Clip on lean_f32"
};

struct ScreenOptions {
    std::size_t queries = 1500, checked = 60;
    int passes = 5;
    double slowest = 1.3;  ///< times the fastest that is in: who takes longer is out
};

struct Screen {
    std::vector<ScreenedCell> cells;  ///< fastest first; those that are out last
    std::size_t left_out = 0;         ///< cells that are missing, since `stop` said so

    /// Whether it is among the cells and out for its error.
    [[nodiscard]] bool is_inexact(const std::string& algorithm, const std::string& table) const;
};

/// `stop` is asked before each cell; the baseline, which is never out for its time, is the first.
[[nodiscard]] Screen screen(const CaseAsked& asked, const ScreenOptions& options,
                            const std::function<bool()>& stop);

}  // namespace edgewise::studies::advise
