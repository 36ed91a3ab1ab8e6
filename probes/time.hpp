// SPDX-License-Identifier: MIT
//
// Time: nanoseconds a query, separated and contact pairs apart; medians over the interleaved rounds with a
// bootstrap interval; and the headline, the median ratio to the baseline cell timed in the same round.
#pragma once

#include "edgewise/measure/probe.hpp"
#include "edgewise/measure/statistics.hpp"

namespace edgewise::probes {

class time final : public Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "time"; }
    [[nodiscard]] std::string_view summary() const override {
        return "median ns a query with 95 % interval, and ratio to the baseline of the same rounds";
    }

    [[nodiscard]] std::vector<Figure> figures(const Subject& subject) const override {
        std::vector<Figure> result;
        add(result, "separated", subject, &Timing::separated_ns, &Timing::separated_queries);
        add(result, "overlapping", subject, &Timing::overlapping_ns, &Timing::overlapping_queries);
        result.push_back({"rounds", static_cast<double>(subject.rounds.size()), "rounds"});
        return result;
    }

  private:
    using Total = double Timing::*;
    using Count = std::uint64_t Timing::*;

    static void add(std::vector<Figure>& result, const std::string& kind, const Subject& subject, Total total,
                    Count count) {
        std::vector<double> each, baseline;
        for (const Round& round : subject.rounds) {
            if (round.timing.*count == 0 || round.baseline.*count == 0) continue;
            each.push_back(round.timing.*total / static_cast<double>(round.timing.*count));
            baseline.push_back(round.baseline.*total / static_cast<double>(round.baseline.*count));
        }
        const std::string reason = subject.rounds.empty() ? "no round was timed"
                                   : each.empty()         ? "the cell has no " + kind + " pair"
                                                          : "too few rounds for an interval";
        const std::string remedy = subject.rounds.empty() ? "run the sweep again, it resumes"
                                   : each.empty()         ? "ask for more queries"
                                                          : "ask for more rounds";
        const auto figure = [&](const std::string& name, std::optional<double> value, const char* unit) {
            result.push_back(value ? Figure{kind + name, value, unit}
                                   : Figure{kind + name, std::nullopt, unit, reason, remedy});
        };
        const auto interval = bootstrap_median(each);
        figure("_ns", median(each), "ns");
        figure("_ns_low", interval ? std::optional(interval->lower) : std::nullopt, "ns");
        figure("_ns_high", interval ? std::optional(interval->upper) : std::nullopt, "ns");
        figure("_ratio", median(paired_ratios(each, baseline)), "1");
    }
};

}  // namespace edgewise::probes
