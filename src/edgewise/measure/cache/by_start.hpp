// SPDX-License-Identifier: MIT
//
// Which queries something is counted of: those that start cold (a pair's first, and every query of a scene
// that keeps no answers), those that start warm (of a pair asked before, from its kept answer), and all. What
// is touched between queries, as by a broad phase, is no query's own and counts among all alone.
#pragma once

#include <cstdint>
#include <optional>

namespace edgewise::measure {

/// What a query starts from.
enum class QueryStart : std::uint8_t { cold, warm };

/// A count over all queries, over those that start cold, and over those that start warm.
template <class Count>
struct ByStart {
    Count all{}, cold{}, warm{};

    [[nodiscard]] Count& of(QueryStart start) { return start == QueryStart::cold ? cold : warm; }
    [[nodiscard]] const Count& of(QueryStart start) const { return start == QueryStart::cold ? cold : warm; }

    /// use(count) of all, and of the query's own start; nothing: it is no query's.
    template <class Use>
    void each(std::optional<QueryStart> start, const Use& use) {
        use(all);
        if (start) use(of(*start));
    }
    void add(std::optional<QueryStart> start, std::uint64_t count) {
        each(start, [&](Count& sum) { sum += count; });
    }
};

}  // namespace edgewise::measure
