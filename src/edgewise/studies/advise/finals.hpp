// SPDX-License-Identifier: MIT
//
// What a race of finalists says: who is fastest, who ties with that, what the baseline differs by from
// itself, and whether what was predicted came true. An interval is between processes, from the least to the
// greatest of their medians.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/studies/advise/finalist.hpp"

namespace edgewise::studies::advise {

/// What ratios are to: the paper's algorithm on the paper's layout.
inline constexpr const char *baseline_algorithm = "vclip", *baseline_table = "aos_f64";

/// This machine among those whose caches are modelled.
inline constexpr const char* this_machine = "host";

struct Finals {
    std::vector<Finalist> ranked;          ///< as exact as was asked, fastest first
    std::vector<Finalist> over_limit;      ///< not as exact: no advice, but the baseline may be one
    double noise_low = 1, noise_high = 1;  ///< the baseline beside itself, over the processes
    int processes = 0;                     ///< that came to their end
    std::vector<double> latencies_ns;      ///< here, beyond the first level: what predictions are of
    std::string problem;                   ///< why the next process did not; empty: there is none

    /// Null where it is none of them.
    [[nodiscard]] const Finalist* find(const std::string& algorithm, const std::string& table) const;
    [[nodiscard]] const Finalist* baseline() const { return find(baseline_algorithm, baseline_table); }

    /// Whether it cannot be told from the fastest: their intervals meet, or they differ by no more than the
    /// baseline does from itself.
    [[nodiscard]] bool ties(const Finalist& one) const;

    /// Null where nothing was predicted of that machine.
    [[nodiscard]] const Finalist* fastest_predicted(const std::string& machine) const;

    /// Whether the fastest by the prediction for this machine is among those that tie; null where there is
    /// no prediction.
    [[nodiscard]] std::optional<bool> prediction_held() const;
};

/// Ratios are to any one cell on entry, the same in all processes; to the baseline's median then, if that is
/// among the finalists. Finalists without a ratio are dropped, those over the limit set aside.
[[nodiscard]] Finals ranked_finals(std::vector<Finalist> finalists, double error_limit);

/// For each machine with modelled misses: the time in cache, and each miss as long as the level takes that
/// answers it, nothing overlapping. `latencies_ns`: here, of each level beyond the first, memory last; those
/// of a machine's own levels are not known, and these stand in for them.
void predict(Finals& finals, std::span<const double> latencies_ns);

}  // namespace edgewise::studies::advise
