// SPDX-License-Identifier: MIT
#include "edgewise/sweep/rounds.hpp"

#include <algorithm>
#include <utility>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::sweep {

namespace {

using StoredRound = std::vector<std::pair<std::string, measure::Round>>;

StoredRound time_round(const Plan& plan, int number, std::vector<const CellRun*> in_order,
                       const CellRun& baseline, double clock_cost_ns) {
    in_order.push_back(&baseline);
    scene::Rng rng(plan.seed + static_cast<std::uint64_t>(number));
    rng.shuffle(in_order);
    StoredRound rounds;
    measure::Timing baseline_timing;
    for (const CellRun* cell : in_order) {
        const measure::Timing timing = cell->time(clock_cost_ns);
        if (cell == &baseline) {
            baseline_timing = timing;
        } else {
            rounds.emplace_back(cell->row().hash, measure::Round{number, timing, {}});
        }
    }
    for (auto& [hash, round] : rounds) round.baseline = baseline_timing;
    return rounds;
}

}  // namespace

void time_rounds(const Plan& plan, std::span<const CellRun> cells, const CellRun& baseline,
                 StoredCells& stored, const std::atomic<bool>& stop) {
    const double clock_cost_ns = measure::calibrate();
    std::vector<std::vector<int>> missing;
    for (const CellRun& cell : cells) missing.push_back(stored.rounds_missing(cell));
    for (int round = 0; round < plan.rounds && !stop; ++round) {
        std::vector<const CellRun*> lacking;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto& of_this = missing[i];
            const bool lacks = std::find(of_this.begin(), of_this.end(), round) != of_this.end();
            if (cells[i].verified() && lacks) lacking.push_back(&cells[i]);
        }
        if (!lacking.empty()) stored.put(time_round(plan, round, lacking, baseline, clock_cost_ns));
    }
}

}  // namespace edgewise::sweep
