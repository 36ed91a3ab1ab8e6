// SPDX-License-Identifier: MIT
//
// Rules for all probes, with a cell that is verified and timed, and with one that is neither: a figure is a
// finite number, or null with a reason, and is in the vocabulary.
#include "edgewise/bench/probe.hpp"

#include <gtest/gtest.h>

#include <set>

#include "edgewise/store/vocabulary.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "found.hpp"

namespace edgewise {
namespace {

TEST(Probes, HaveNamesOfTheirOwnAndSayWhatTheyMeasure) {
    std::set<std::string_view> names;
    ASSERT_FALSE(bench::registered_probes().empty());
    for (const bench::Probe& probe : bench::registered_probes()) {
        EXPECT_TRUE(names.insert(probe.name).second) << probe.name;
        EXPECT_FALSE(probe.summary.empty());
    }
}

TEST(Probes, FindNumbersOrSayWhyNot) {
    const studies::SingleCell cell({"aos_f64", "gjk", "tumble", "cube8", {{"in_time_order", 1}}, 200, 1});
    const std::vector<truth::CheckedAnswer> checked(10);
    const std::size_t positions[] = {0, 20, 40, 60, 80, 100, 120, 140, 160, 180};
    const measure::Round round = {0, {150, 50, 1e5, 2e4}, {150, 50, 2e5, 3e4}};
    const std::vector<measure::Round> rounds(9, round);
    for (const bool verified : {true, false}) {
        const bench::ProbedCell probed{.type = cell.type(),
                                       .algorithm = bench::algorithm_called("gjk"),
                                       .runner = cell.runner(),
                                       .workload = cell.workload(),
                                       .verified = verified,
                                       .checked_positions = positions,
                                       .checked = checked,
                                       .counts = {200, 700, 0, 0, 9, 0, 0, 150, 90},
                                       .rounds = std::span(rounds).first(verified ? 9 : 0)};
        for (const bench::Probe& probe : bench::registered_probes()) {
            const bench::Findings found = probe.measure(probed);
            EXPECT_FALSE(by_name(found.figures).empty()) << probe.name;
            for (const measure::Figure& figure : found.figures) {
                const store::FigureInfo* known = store::find_figure(probe.name, figure.name);
                EXPECT_TRUE(known && figure.unit.starts_with(known->unit))
                    << figure.name << " in " << figure.unit;
            }
            if (!found.passed) continue;
            double sum = 0;
            for (const Distance& answer : cell.runner().answer()) sum += answer.distance;
            EXPECT_EQ(found.passed->distances, sum) << probe.name << " gives the same answers";
        }
    }
}

}  // namespace
}  // namespace edgewise
