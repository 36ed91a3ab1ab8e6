// SPDX-License-Identifier: MIT
//
// One timed repetition of a cell, with the baseline cell timed in the same round.
#pragma once

#include <cstdint>
#include <optional>

#include "edgewise/measure/cache/by_start.hpp"

namespace edgewise::measure {

struct Timing {
    std::uint64_t separated_queries = 0, overlapping_queries = 0;
    double separated_ns = 0, overlapping_ns = 0;  ///< total time per kind, clock cost subtracted
    /// Queries of unknown kind: their answers do not say if the bodies are in contact.
    std::uint64_t either_queries = 0;
    double either_ns = 0;
    /// First queries of followed pairs, which start cold. Each is timed alone, and is not counted above.
    std::uint64_t first_queries = 0;
    double first_ns = 0;

    /// Returns nanoseconds per query of each kind, and of all in their order; nothing if none was timed.
    [[nodiscard]] std::optional<double> separated() const {
        return per_query(separated_ns, separated_queries);
    }
    [[nodiscard]] std::optional<double> overlapping() const {
        return per_query(overlapping_ns, overlapping_queries);
    }
    [[nodiscard]] std::optional<double> all() const {
        return per_query(separated_ns + overlapping_ns + either_ns,
                         separated_queries + overlapping_queries + either_queries);
    }

    /// Nanoseconds per query by how queries start; `warm_scene`: pairs are followed. `all` is both starts.
    [[nodiscard]] ByStart<std::optional<double>> by_start(bool warm_scene) const {
        const std::uint64_t steady = separated_queries + overlapping_queries + either_queries;
        const double steady_ns = separated_ns + overlapping_ns + either_ns;
        return {per_query(steady_ns + first_ns, steady + first_queries),
                warm_scene ? per_query(first_ns, first_queries) : all(), warm_scene ? all() : std::nullopt};
    }

  private:
    static std::optional<double> per_query(double ns, std::uint64_t queries) {
        if (queries == 0) return std::nullopt;
        return ns / static_cast<double>(queries);
    }
};

/// Which queries: `&Timing::separated`, `&Timing::overlapping` or `&Timing::all`.
using PerQuery = std::optional<double> (Timing::*)() const;

struct Round {
    int number = 0;
    Timing timing = {};
    Timing baseline = {};  ///< of the same round

    /// Time per query over the baseline's; null where either timed no such query.
    [[nodiscard]] std::optional<double> ratio(PerQuery per_query) const {
        const auto own = (timing.*per_query)(), beside = (baseline.*per_query)();
        if (!own || !beside || *own <= 0 || *beside <= 0) return std::nullopt;
        return *own / *beside;
    }
};

}  // namespace edgewise::measure
