// SPDX-License-Identifier: MIT
//
// One table at many scales compared with one table per scale: bytes saved, time lost, and the time
// to build or to refit a table instead (bench/scales/scale_study.hpp). The scene gives the body
// alone; its poses and scales come from that study.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class scale {
  public:
    static constexpr std::string_view summary =
        "GJK over one table at 64 scales compared with 64 tables: time, bytes, time to build";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        if (!cell.verified) return none("a checked answer is wrong", "fix the wrong answer first");
        if (!cell.plain) return none("measured for the cell without further axes", "that cell");
        if (cell.algorithm.name != "gjk")
            return none("V-Clip needs a table of the stretched body", "algorithm gjk");
        if (cell.workload.warm) return none("measured where no pair is followed", "scene cold");
        const bench::ScaleTimes times = cell.runner.scale_times(repetitions);
        if (times.scales == 0)
            return none("this layout is not measured at many scales", "layouts lean and aos");
        return {figures(times)};
    }

    /// Figures of the measured times.
    [[nodiscard]] static std::vector<measure::Figure> figures(const bench::ScaleTimes& times) {
        const std::vector<double> ratios = measure::paired_ratios(times.shared_ns, times.own_ns);
        const auto interval = measure::bootstrap_median(ratios);
        return {of("scale.shared_query_ns", measure::median(times.shared_ns)),
                of("scale.own_query_ns", measure::median(times.own_ns)),
                of("scale.shared_over_own", measure::median(ratios)),
                of("scale.shared_over_own_low", interval ? std::optional(interval->lower) : std::nullopt),
                of("scale.shared_over_own_high", interval ? std::optional(interval->upper) : std::nullopt),
                of("scale.shared_bytes", times.shared_bytes),
                of("scale.own_bytes", times.own_bytes),
                of("scale.build_ns", measure::median(times.build_ns)),
                of("scale.refit_ns", measure::median(times.refit_ns)),
                of("scale.other_bits", static_cast<double>(times.other_bits)),
                of("scale.worst_error", times.error)};
    }

  private:
    static constexpr int repetitions = 17;

    [[nodiscard]] static measure::Figure of(const store::FigureName& name, std::optional<double> value) {
        return store::figure(name, value, "too few repetitions", "run the sweep again");
    }
    [[nodiscard]] static bench::Findings none(const std::string& reason, const std::string& remedy) {
        bench::Findings findings;
        for (const measure::Figure& figure : figures({}))
            findings.figures.push_back({figure.name, std::nullopt, figure.unit, reason, remedy});
        return findings;
    }
};

}  // namespace edgewise::probes
