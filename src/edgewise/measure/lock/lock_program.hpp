// SPDX-License-Identifier: MIT
//
// A layout's lock: its deterministic figures in a file that is kept under version control next to the layout,
// so that a change of the layout shows as a change of that file. Nothing in it depends on addresses, on a
// clock or on the machine that made it. A lock is a record of kind "lock" (record/record.hpp) without slack.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"
#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/record/record.hpp"
#include "edgewise/measure/touch/touch_trace.hpp"

namespace edgewise::measure {

// What is measured of a layout without a clock: bytes by component, distinct lines of 64 bytes per query,
// modelled misses by machine, level and field in the steady state (the second of two passes over the same
// accesses, cache/scene_caches.hpp), what queries miss that find all caches empty (the same header),
// and the knee. All of queries that start cold, warm, and of both.

struct LayoutFacts {
    struct Machine {
        std::string name;
        ByStart<MachineMisses> steady;
        ByStart<std::uint64_t> emptied;  ///< of the first level, by queries that find every cache empty
    };

    std::vector<ComponentBytes> bytes;
    ByStart<LinesTouched> lines;  ///< sums over queries
    std::vector<Machine> machines;
    std::vector<std::string> fields;  ///< names by number
    std::uint64_t distinct_lines = 0;
    /// The smallest fully associative cache in which a query finds nine tenths of what it comes back to
    /// (cache/reuse_distance.hpp); nothing: no query starts so.
    ByStart<std::optional<std::uint64_t>> knee_bytes;
};

/// pass: reports the same accesses to a listener on every call, with fields below fields.size() and steps
/// below `steps`. Bytes are left empty.
[[nodiscard]] LayoutFacts measure_layout(const std::function<void(TraceListener&)>& pass,
                                         std::span<const CacheMachine> machines,
                                         std::vector<std::string> fields, std::size_t steps = 1);

/// Measures a user's own structure; no value if the trace has a problem or no queries.
[[nodiscard]] Expected<LayoutFacts> measure_layout(const TouchTrace& trace,
                                                   std::span<const CacheMachine> machines);

/// Calls use(suffix, of) for all queries (""), and for those that start cold (".cold") and warm (".warm") if
/// there are any: how figures of populations are named everywhere.
template <class Use>
void each_population(const ByStart<LinesTouched>& lines, Use use) {
    use(
        std::string_view(""), [](const auto& by_start) -> const auto& { return by_start.all; });
    if (lines.cold.queries > 0)
        use(
            std::string_view(".cold"), [](const auto& by_start) -> const auto& { return by_start.cold; });
    if (lines.warm.queries > 0)
        use(
            std::string_view(".warm"), [](const auto& by_start) -> const auto& { return by_start.warm; });
}

/// A page for people: the figures of a lock, and misses by level and field.
[[nodiscard]] std::string to_text(const LayoutFacts& facts);

/// Figures: bytes by component and in all; per population queries, lines per query, the knee in bytes, and
/// misses per query by machine and level, TLBs among them, and of the first level where queries find all
/// caches empty. `of`: whatever must be the same for figures to be comparable.
[[nodiscard]] FigureRecord lock_of(const LayoutFacts& facts, Conditions of = {});

/// The whole of a test that holds a lock: `tree_lock > tree.lock.json` writes it, `tree_lock --check
/// tree.lock.json` compares, as `edgewise lock` does for the tables of Edgewise. Exit codes: 0 written, or
/// the lock holds; 1 it does not, each difference is a line on stdout; 2 there is nothing to compare, or
/// other arguments (one line on stderr).
[[nodiscard]] int lock_program(int argc, const char* const* argv, const Expected<LayoutFacts>& facts,
                               Conditions of = {});

}  // namespace edgewise::measure
