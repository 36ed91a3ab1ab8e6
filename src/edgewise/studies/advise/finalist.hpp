// SPDX-License-Identifier: MIT
//
// An algorithm on a table type that was raced in several processes: what it took in each, and what else is
// known of it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgewise::studies::advise {

struct Finalist {
    std::string algorithm, table;
    std::vector<double> ratios, ns;  ///< to the baseline, and per query: one for each process
    double bytes_per_edge = 0, table_bytes = 0;
    double error = 0;  ///< worst of the checked answers against the bodies as given, divided by the scale
    double steps = 0;  ///< per query
    std::optional<double> lines;        ///< per query; none: no time was left to trace it
    std::optional<double> in_cache_ns;  ///< per query, few bodies with one table; none: likewise
    /// Modelled misses per query, by machine, level by level from the first on.
    std::map<std::string, std::vector<double>> misses;
    std::map<std::string, double> predicted_ns;  ///< per query, by machine

    [[nodiscard]] double low() const;  ///< of the ratios
    [[nodiscard]] double mid() const;  ///< the median
    [[nodiscard]] double high() const;
    [[nodiscard]] double mid_ns() const;  ///< in the process of the median ratio
    [[nodiscard]] bool is(const std::string& algorithm, const std::string& table) const;
    [[nodiscard]] std::string name() const;  ///< "V-Clip on lean_f32"
};

}  // namespace edgewise::studies::advise
