// SPDX-License-Identifier: MIT
//
// Support queries without GJK around them: the time to find the farthest vertex along a direction, from the
// start of a table and from the last answer (bench/support_times.hpp). Of a scene with many tables these are
// asked in turn, so that each has left the caches again.
#pragma once

#include <string_view>

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class support {
  public:
    static constexpr std::string_view summary =
        "median time of a support query, from a cold and a warm start";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        if (!cell.verified) return none("a checked answer is wrong", "fix the wrong answer first");
        if (!cell.plain) return none("measured for the cell without further axes", "that cell");
        if (cell.algorithm.name != "gjk") return none("only GJK asks for support points", "algorithm gjk");
        const bench::SupportTimes times = cell.runner.support_times(repetitions);
        return {{of(store::StartNames::cold_start, times.cold_ns),
                 of(store::StartNames::warm_start, times.warm_ns)}};
    }

  private:
    static constexpr int repetitions = 9;
    static constexpr store::FigureName query_ns{"support.query_ns.{start}"};

    [[nodiscard]] static measure::Figure of(std::string_view start, const std::vector<double>& ns) {
        return store::figure(query_ns.of(std::string(start)), measure::median(ns), "no table was asked",
                             "run the sweep again");
    }
    [[nodiscard]] static bench::Findings none(const char* reason, const char* remedy) {
        return {{store::no_figure(query_ns.of(std::string(store::StartNames::cold_start)), reason, remedy),
                 store::no_figure(query_ns.of(std::string(store::StartNames::warm_start)), reason, remedy)}};
    }
};

}  // namespace edgewise::probes
