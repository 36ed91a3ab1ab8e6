// SPDX-License-Identifier: MIT
//
// What a table costs to make: preprocessing, from the canonical body with its face planes, hull and planes
// not counted; and again after a deformation that keeps the topology, refitted in place where the layout can.
// Both are timed alternately, so that their ratio means more than either.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class build final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "build"; }
    [[nodiscard]] std::string_view summary() const override {
        return "median time to build a table, and to refit it in place to the body deformed";
    }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        return {figures(cell.runner.build_times(repetitions))};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::BuildTimes& times) {
        const char* const no_refit = "this layout cannot be refitted in place";
        const std::vector<double> ratios = times.refit_ns.empty()
                                               ? std::vector<double>{}
                                               : measure::paired_ratios(times.refit_ns, times.build_ns);
        return {of("build.build_ns", times.build_ns, "no table was built", "run the sweep again"),
                of("build.refit_ns", times.refit_ns, no_refit, "build a new table"),
                of("build.refit_over_build", ratios, no_refit, "build a new table")};
    }

  private:
    static constexpr int repetitions = 15;  ///< an odd number, for a median that was measured

    static measure::Figure of(const store::FigureName& name, const std::vector<double>& sample,
                              const char* reason, const char* remedy) {
        if (const auto middle = measure::median(sample)) return store::figure(name, middle);
        return store::no_figure(name, reason, remedy);
    }
};

}  // namespace edgewise::probes
