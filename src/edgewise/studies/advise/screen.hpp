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

struct ScreenedCell {
    const bench::TableType* type = nullptr;
    std::string algorithm;
    double bytes_per_edge = 0, table_bytes = 0;
    double error = 0;      ///< worst of the checked answers against the bodies as given, divided by the scale
    double ns = 0;         ///< per query, the shortest pass
    double steps = 0;      ///< per query
    std::string out;       ///< why it is out of question; empty: it is not
    bool is_slow = false;  ///< and that is all that is wrong with it

    [[nodiscard]] std::string name() const;  ///< "V-Clip on lean_f32"
};

struct ScreenOptions {
    std::size_t queries = 1500, checked = 60;
    int passes = 5;
    double slowest = 1.3;  ///< times the fastest that is in: who takes longer is out
};

struct Screen {
    std::vector<ScreenedCell> cells;  ///< fastest first; those that are out last
    bool stopped = false;             ///< `stop` said so: cells are missing
};

/// `stop` is asked before each cell. The paper's algorithm on the paper's layout is never out for its time.
[[nodiscard]] Screen screen(const CaseAsked& asked, const ScreenOptions& options,
                            const std::function<bool()>& stop);

}  // namespace edgewise::studies::advise
