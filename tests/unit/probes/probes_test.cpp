// SPDX-License-Identifier: MIT
//
// Probes on made-up cells: what any of them must keep (a figure is a finite number, or null with a reason),
// and the figures that others rely on, from numbers whose results are known.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "edgewise/measure/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise {
namespace {

/// A table of 100 bytes and 168 more an edge, of which the planes take 128.
measure::TableBytes table_of(std::uint64_t edges) {
    measure::TableBytes table;
    table.vertices = (edges + 6) / 3;
    table.edges = edges;
    const auto e = static_cast<double>(edges);
    table.components = {{"voronoi_planes", 128 * e}, {"edge_geometry", 40 * e}, {"padding", 100}};
    table.paper_subtotal = 168 * e;
    table.total = 168 * e + 100;
    return table;
}

measure::Round round_of(int number, double ns, double baseline_ns) {
    return {number, {10, 5, 10 * ns, 5 * 2 * ns}, {10, 5, 10 * baseline_ns, 5 * 2 * baseline_ns}};
}

class Probes : public ::testing::Test {
  protected:
    Probes() {
        for (const std::uint64_t edges : {12U, 108U, 1152U}) sizes_.push_back(table_of(edges));
        for (int i = 0; i < 10; ++i) {
            measure::CheckedAnswer answer;
            answer.separated = i < 7;
            answer.touching = i == 7;
            answer.error_stored = i * 1e-15;
            answer.error_given = i * 1e-8;
            answer.witness_error = i * 1e-16;
            checked_.push_back(answer);
        }
        checked_[9].verdict_wrong = true;
        checked_[4].in_band = true;
        for (int i = 0; i < 9; ++i) rounds_.push_back(round_of(i, 100 + i, 200 + 2 * i));
        subject_.table = table_of(108);
        subject_.sizes = sizes_;
        subject_.checked = checked_;
        subject_.counts = {1000, 1500, 3, 2, 17, 5, 8};
        subject_.rounds = rounds_;
        subject_.memory = {12, 12000, 12800, 16384.0, 0.25};
        subject_.build = {{100, 300, 200}, {50, 60, 80}};
        subject_.touched = {10, 400, 6400, 150};
    }

    /// The figures of a probe by name; none where this program has no such probe.
    [[nodiscard]] static std::map<std::string, measure::Figure> figures(std::string_view name,
                                                                        const measure::Subject& subject) {
        std::map<std::string, measure::Figure> result;
        for (const auto& probe : measure::registered_probes()) {
            if (probe->name() != name) continue;
            for (measure::Figure& figure : probe->figures(subject)) result[figure.name] = figure;
        }
        return result;
    }

    std::vector<measure::TableBytes> sizes_;
    std::vector<measure::CheckedAnswer> checked_;
    std::vector<measure::Round> rounds_;
    measure::Subject subject_;
};

void expect_sound(const measure::Probe& probe, const measure::Subject& subject) {
    std::set<std::string> names;
    for (const measure::Figure& figure : probe.figures(subject)) {
        EXPECT_TRUE(names.insert(figure.name).second) << figure.name << " twice";
        const store::FigureInfo* known = store::find_figure(probe.name(), figure.name);
        EXPECT_TRUE(known && figure.unit.starts_with(known->unit)) << figure.name << " in " << figure.unit;
        if (figure.value) {
            EXPECT_TRUE(std::isfinite(*figure.value)) << figure.name;
            EXPECT_TRUE(figure.reason.empty()) << figure.name;
        } else {
            EXPECT_FALSE(figure.reason.empty()) << figure.name << " is null without a reason";
        }
    }
}

TEST_F(Probes, HaveNamesOfTheirOwnAndSayWhatTheyMeasure) {
    std::set<std::string_view> names;
    ASSERT_FALSE(measure::registered_probes().empty());
    for (const auto& probe : measure::registered_probes()) {
        EXPECT_TRUE(names.insert(probe->name()).second) << probe->name();
        EXPECT_FALSE(probe->summary().empty());
    }
}

TEST_F(Probes, EveryFigureIsANumberOrNullWithAReason) {
    measure::Subject untimed = subject_;
    untimed.rounds = {};
    measure::Subject few_rounds = subject_;
    few_rounds.rounds = few_rounds.rounds.first(2);
    measure::Subject without_planes = subject_;
    without_planes.table.paper_subtotal = 0;
    measure::Subject unchecked = subject_;
    unchecked.checked = {};
    unchecked.counts = {};
    unchecked.sizes = {};
    for (const auto& probe : measure::registered_probes()) {
        for (const measure::Subject& subject : {subject_, untimed, few_rounds, without_planes, unchecked}) {
            expect_sound(*probe, subject);
        }
    }
}

TEST_F(Probes, BytesAreSharesAndSlopes) {
    auto found = figures("bytes", subject_);
    if (found.empty()) GTEST_SKIP() << "no such probe";
    EXPECT_EQ(found["voronoi_planes"].value, 128);
    EXPECT_EQ(found["padding"].value, 100.0 / 108);
    EXPECT_EQ(found["paper_bytes_per_edge"].value, 168);
    EXPECT_EQ(found["slope_bytes_per_edge"].value, 168);
    EXPECT_EQ(found["total_bytes_per_edge"].value, 168 + 100.0 / 108);
    EXPECT_EQ(found["table_bytes"].value, 168 * 108 + 100);
    subject_.table.paper_subtotal = 0;
    EXPECT_FALSE(figures("bytes", subject_)["paper_bytes_per_edge"].value);
}

TEST_F(Probes, LinesAreMeansOverQueries) {
    auto found = figures("lines", subject_);
    if (found.empty()) GTEST_SKIP() << "no such probe";
    EXPECT_EQ(found["lines_per_query"].value, 15);
    EXPECT_EQ(found["line_bytes_per_query"].value, 15 * 64);
    EXPECT_EQ(found["read_bytes_per_query"].value, 640);
    EXPECT_EQ(found["reads_per_query"].value, 40);
    subject_.touched = {};
    EXPECT_FALSE(figures("lines", subject_)["lines_per_query"].value);
}

TEST_F(Probes, MemoryIsOfAllTables) {
    auto found = figures("memory", subject_);
    if (found.empty()) GTEST_SKIP() << "no such probe";
    EXPECT_EQ(found["tables"].value, 12);
    EXPECT_EQ(found["requested_bytes"].value, 12000);
    EXPECT_EQ(found["taken_bytes"].value, 12800);
    EXPECT_EQ(found["resident_bytes"].value, 16384);
    EXPECT_EQ(found["materialised"].value, 0.25);
    subject_.memory.resident = std::nullopt;
    EXPECT_FALSE(figures("memory", subject_)["resident_bytes"].value);
}

TEST_F(Probes, BuildsAreMediansAndTheRatioIsOfPairs) {
    auto found = figures("build", subject_);
    if (found.empty()) GTEST_SKIP() << "no such probe";
    EXPECT_EQ(found["build_ns"].value, 200);
    EXPECT_EQ(found["refit_ns"].value, 60);
    EXPECT_EQ(found["refit_over_build"].value, 0.4) << "of 0.5, 0.2 and 0.4";
    subject_.build.refit_ns.clear();
    EXPECT_FALSE(figures("build", subject_)["refit_ns"].value);
    EXPECT_FALSE(figures("build", subject_)["refit_over_build"].value);
}

TEST_F(Probes, TimesAreMediansAndRatiosOfTheSameRound) {
    auto found = figures("time", subject_);
    if (found.empty()) GTEST_SKIP() << "no such probe";
    EXPECT_EQ(found["separated_ns"].value, 104);
    EXPECT_EQ(found["overlapping_ns"].value, 208);
    EXPECT_EQ(found["separated_ratio"].value, 0.5);
    EXPECT_LT(found["separated_ns_low"].value, 104);
    EXPECT_GT(found["separated_ns_high"].value, 104);
    EXPECT_EQ(found["rounds"].value, 9);
    subject_.rounds = {};
    EXPECT_FALSE(figures("time", subject_)["separated_ns"].value);
}

TEST_F(Probes, ErrorsAreTheWorstAndVerdictsAreCounted) {
    auto found = figures("error", subject_);
    if (found.empty()) GTEST_SKIP() << "no such probe";
    EXPECT_EQ(found["checked"].value, 10);
    EXPECT_EQ(found["worst_error_stored"].value, checked_[9].error_stored);
    EXPECT_EQ(found["worst_error_given"].value, checked_[9].error_given);
    EXPECT_EQ(found["wrong_verdicts"].value, 1);
    EXPECT_EQ(found["verdicts_in_band"].value, 1);
    EXPECT_EQ(found["separated"].value, 7);
    EXPECT_EQ(found["touching"].value, 1);
    EXPECT_EQ(found["overlapping"].value, 2);
    EXPECT_EQ(found["fallbacks"].value, 3);
    EXPECT_EQ(found["cycles"].value, 2);
    EXPECT_EQ(found["refinements"].value, 5);
    EXPECT_EQ(found["escapes"].value, 8);
    EXPECT_EQ(found["mean_steps"].value, 1.5);
    EXPECT_EQ(found["max_steps"].value, 17);
}

TEST_F(Probes, TimesOfAllPairsAreTheBothTogether) {
    const auto time = figures("time", subject_);
    if (time.empty()) GTEST_SKIP();
    // 10 separated at 104 ns and 5 overlapping at twice that, a median round of the nine.
    EXPECT_NEAR(*time.at("all_ns").value, (10 * 104.0 + 5 * 208.0) / 15, 1e-9);
    EXPECT_LE(*time.at("all_ns_low").value, *time.at("all_ns").value);
    EXPECT_GE(*time.at("all_ns_high").value, *time.at("all_ns").value);
    EXPECT_NEAR(*time.at("all_ratio").value, 0.5, 1e-9);
}

TEST_F(Probes, ControlIsCountedOrSaidNotToBeAsked) {
    EXPECT_FALSE(figures("error", subject_).at("control_disagreements").value);
    checked_[4].control_disagrees = true;  // in the band
    checked_[5].control_disagrees = true;
    checked_[6].control_disagrees = false;
    const auto error = figures("error", subject_);
    EXPECT_EQ(error.at("control_checked").value, 3);
    EXPECT_EQ(error.at("control_disagreements").value, 2);
    EXPECT_EQ(error.at("control_disagreements_outside_band").value, 1);
}

TEST_F(Probes, CostFunctionsAreSumsOfTheirTerms) {
    EXPECT_FALSE(figures("cost", subject_).at("step_ns").value);
    subject_.costs = {10, 100, 300, 50, 7, 20, 2, 400, 25000, "", ""};
    const auto cost = figures("cost", subject_);
    EXPECT_EQ(cost.at("equation_1_ns").value, 300 * 2 + 50 * 400);
    EXPECT_EQ(cost.at("equation_2_ns").value, 300 * 2 + 50 * 400 + 100 * 20);
    EXPECT_EQ(cost.at("all_pairs").value, 4950);
    EXPECT_NEAR(*cost.at("equation_2_ratio").value, 22600.0 / 25000, 1e-12);
}

TEST_F(Probes, WorkIsSharesOfWhatWasLookedAt) {
    subject_.counts.warm = 800;
    subject_.counts.unchanged = 200;
    EXPECT_EQ(figures("work", subject_).at("unchanged").value, 0.25);
    EXPECT_FALSE(figures("work", subject_).at("support_unchanged").value);
    subject_.work = {100, 50, 25, 400, 80, 60, 72, 200, 500, {20, 60, 100, 20}, 40, 30, "", ""};
    const auto work = figures("work", subject_);
    EXPECT_EQ(work.at("support_unchanged").value, 0.75);
    EXPECT_EQ(work.at("support_near").value, 0.9);
    EXPECT_EQ(work.at("hops_per_support").value, 0.5);
    EXPECT_EQ(work.at("vertices_per_support").value, 8);
    EXPECT_EQ(work.at("subsets_tried").value, 2.5);
    EXPECT_EQ(work.at("accepted_3").value, 0.5);
    EXPECT_EQ(work.at("features_agree").value, 0.75);
}

}  // namespace
}  // namespace edgewise
