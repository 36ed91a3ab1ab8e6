// SPDX-License-Identifier: MIT
//
// Cost of making a table: preprocessing, from the canonical body with its face planes, hull and planes
// not counted; and again after a deformation that keeps the topology, refitted in place where the layout can.
// Both are timed alternately, so that their ratio means more than either.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class build {
  public:
    static constexpr std::string_view summary =
        "median time to build a table, and to refit it in place to the body deformed";

    static constexpr bool of_peers = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(cell.runner.build_times(repetitions))};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const bench::BuildTimes& times) {
        const char* const no_refit = "this layout cannot be refitted in place";
        const std::vector<double> ratios = times.refit_ns.empty()
                                               ? std::vector<double>{}
                                               : measure::paired_ratios(times.refit_ns, times.build_ns);
        return {
            store::figure("build.build_ns", measure::median(times.build_ns), "no table was built",
                          "run the sweep again"),
            store::figure("build.refit_ns", measure::median(times.refit_ns), no_refit, "build a new table"),
            store::figure("build.refit_over_build", measure::median(ratios), no_refit, "build a new table")};
    }

  private:
    static constexpr int repetitions = 15;  ///< an odd number, for a median that was measured
};

}  // namespace edgewise::probes
