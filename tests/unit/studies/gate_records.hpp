// SPDX-License-Identifier: MIT
//
// Records of a guard on speed with known truths: rounds are drawn as a machine gives them, with noise of each
// time, and phases in which all is slower.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/scene/rng.hpp"
#include "edgewise/studies/gate/run.hpp"

namespace edgewise::studies {

/// Returns the true ratio of row i: its time divided by its reference's, before noise.
[[nodiscard]] inline double true_ratio(std::size_t i) { return 0.5 + 0.25 * static_cast<double>(i % 12); }

/// Up to 4 % more than the truth, and one time in twenty, hit by an interrupt, twice of it.
[[nodiscard]] inline double noisy(double truth, scene::Rng& rng) {
    return truth * (1 + 0.04 * rng.uniform()) * (rng.below(20) == 0 ? 2 : 1);
}

/// Row `slowed` takes `factor` times as long.
[[nodiscard]] inline measure::FigureRecord drawn_record(std::uint64_t seed, std::size_t slowed,
                                                        double factor) {
    constexpr std::size_t rows = 40;
    constexpr int rounds = 17;
    scene::Rng rng(seed);
    measure::FigureRecord record{speed_kind, {}, {{"machine", "one"}, {"compiler", "c"}}, 0.1, {}};
    for (std::size_t i = 0; i < rows; ++i) {
        std::vector<double> times, beside;
        for (int round = 0; round < rounds; ++round) {
            const double mood = rng.uniform(1, 3);
            times.push_back(noisy(mood * true_ratio(i) * (i == slowed ? factor : 1), rng));
            beside.push_back(noisy(mood, rng));
        }
        record.rows.push_back(
            gate_row("gjk table" + std::to_string(i) + " cold cube8" + (i % 3 == 0 ? " batch=yes" : ""),
                     i == 0 ? over_kernel : over_reference, times, beside)
                .value());
    }
    return record;
}

}  // namespace edgewise::studies
