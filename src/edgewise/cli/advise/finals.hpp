// SPDX-License-Identifier: MIT
//
// The finalists of an advice in processes of their own, one after the other: what differs between processes
// is what an interval within one does not know. Each is a sweep of this program into a store of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/studies/advise/screen.hpp"

namespace edgewise::cli {

struct Finalist {
    std::string algorithm, table;
    std::vector<double> ratios;   ///< to the baseline, one for each process
    double ns = 0;                ///< per query, in the process of the median ratio
    double in_cache_ns = 0;       ///< per query, three bodies with one table
    double predicted_ns = 0;      ///< of the case, from that and modelled misses; 0: not known
    double steps = 0, lines = 0;  ///< per query
    double bytes_per_edge = 0, table_bytes = 0, error = 0;
    /// Modelled misses per query, by machine, level by level from the first on.
    std::map<std::string, std::vector<double>> misses;

    [[nodiscard]] double low() const;
    [[nodiscard]] double mid() const;  ///< the median
    [[nodiscard]] double high() const;
    [[nodiscard]] std::string name() const;
};

struct Finals {
    std::vector<Finalist> ranked;          ///< fastest first
    double noise_low = 1, noise_high = 1;  ///< the baseline beside itself, over the processes
    int processes = 0;
    std::vector<double> latencies_ns;  ///< here, beyond the first level: what predictions are of
    std::string problem;               ///< why there is nothing; empty: there is

    [[nodiscard]] const Finalist* find(const std::string& algorithm, const std::string& table) const;
    [[nodiscard]] bool ties(const Finalist& one) const;  ///< its interval reaches that of the fastest
    [[nodiscard]] const Finalist& fastest_predicted() const;
};

struct FinalsOptions {
    std::vector<std::string> machines;  ///< whose caches are modelled, as for choose_machines; host is added
    int processes = 3;
    std::size_t queries = 3000;
    int rounds = 25;
};

/// `stop` is asked before each process.
[[nodiscard]] Finals run_finals(const studies::advise::CaseAsked& asked,
                                const std::vector<studies::advise::ScreenedCell>& finalists,
                                const FinalsOptions& options, const std::function<bool()>& stop);

}  // namespace edgewise::cli
