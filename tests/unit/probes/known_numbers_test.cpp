// SPDX-License-Identifier: MIT
//
// Probes on known numbers: medians, means, shares and slopes.
//
// The worst of known errors, their quantiles, and counts of verdicts.
#include <gtest/gtest.h>

#include <set>

#include "edgewise/probes/build.hpp"
#include "edgewise/probes/bytes.hpp"
#include "edgewise/probes/error.hpp"
#include "edgewise/probes/lines.hpp"
#include "edgewise/probes/memory.hpp"
#include "edgewise/probes/pairs.hpp"
#include "found.hpp"

namespace edgewise::probes {
namespace {

/// A table of 100 bytes and 168 more for each edge; the planes take 128 of the 168.
TableBytes table_of(std::uint64_t edges) {
    TableBytes table;
    table.vertices = (edges + 6) / 3;
    table.edges = edges;
    table.ledger[Component::voronoi_planes] = 128 * edges;
    table.ledger[Component::edge_geometry] = 40 * edges;
    table.ledger[Component::padding] = 100;
    return table;
}

TEST(Bytes, AreSharesAndSlopes) {
    const std::vector<TableBytes> sizes = {table_of(12), table_of(108), table_of(1152)};
    TableBytes table = table_of(108);
    expect_values(bytes::figures(table, sizes), {{"voronoi_planes", 128},
                                                 {"padding", 100.0 / 108},
                                                 {"paper_bytes_per_edge", 168},
                                                 {"slope_bytes_per_edge", 168},
                                                 {"total_bytes_per_edge", 168 + 100.0 / 108},
                                                 {"table_bytes", 168 * 108 + 100}});
    table.ledger[Component::voronoi_planes] = 0;
    EXPECT_FALSE(by_name(bytes::figures(table, sizes))["paper_bytes_per_edge"].value);
    EXPECT_FALSE(by_name(bytes::figures(table, {}))["slope_bytes_per_edge"].value);
}

TEST(Build, IsMediansAndTheRatioIsOfPairs) {
    bench::BuildTimes times = {{100, 300, 200}, {50, 60, 80}};
    auto found = by_name(build::figures(times));
    EXPECT_EQ(found["build_ns"].value, 200);
    EXPECT_EQ(found["refit_ns"].value, 60);
    EXPECT_EQ(found["refit_over_build"].value, 0.4) << "of 0.5, 0.2 and 0.4";
    times.refit_ns.clear();
    EXPECT_FALSE(by_name(build::figures(times))["refit_ns"].value);
    EXPECT_FALSE(by_name(build::figures(times))["refit_over_build"].value);
}

TEST(Lines, AreMeansOverQueries) {
    measure::ByStart<measure::LinesTouched> touched{
        {10, 400, 6400, 150}, {4, 300, 4400, 110}, {6, 100, 2000, 40}};
    expect_values(lines::figures(touched), {{"lines_per_query", 15},
                                            {"line_bytes_per_query", 15 * 64},
                                            {"read_bytes_per_query", 640},
                                            {"reads_per_query", 40},
                                            {"lines_per_query.cold", 27.5},
                                            {"reads_per_query.cold", 75},
                                            {"lines_per_query.warm", 40 / 6.0},
                                            {"read_bytes_per_query.warm", 2000 / 6.0}});
    touched.warm = {};
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query.warm"].value);
    EXPECT_EQ(by_name(lines::figures(touched))["lines_per_query.warm"].reason, "no query here starts warm");
    touched = {};
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query"].value);
    touched.all.queries = 10;
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query"].value) << "the loader saw no read";
    EXPECT_EQ(by_name(lines::figures(touched, true))["lines_per_query"].value, 0) << "bounds told all";
}

TEST(Memory, IsOfAllTables) {
    bench::MemoryUse use = {12, 12000, 12800, 16384.0, 0.25};
    expect_values(memory::figures(use), {{"tables", 12},
                                         {"requested_bytes", 12000},
                                         {"taken_bytes", 12800},
                                         {"resident_bytes", 16384},
                                         {"materialised", 0.25}});
    use.resident = std::nullopt;
    EXPECT_FALSE(by_name(memory::figures(use))["resident_bytes"].value);
}

TEST(Pairs, AreMadeAndFoundInEveryRepetition) {
    const std::vector<std::uint64_t> keys = pairs::keys_of(500);
    EXPECT_EQ(std::set<std::uint64_t>(keys.begin(), keys.end()).size(), 500U);
    for (const std::size_t bytes : {8U, 9U, 32U, 40U, 100U}) {
        const pairs::Times times = pairs::timed(bytes, keys);
        ASSERT_EQ(times.creation_ns.size(), times.find_ns.size());
        EXPECT_EQ(times.found, 500 * times.find_ns.size()) << bytes;
        for (const double ns : times.creation_ns) EXPECT_GT(ns, 0);
    }
}

std::vector<truth::CheckedAnswer> ten_answers() {
    std::vector<truth::CheckedAnswer> checked;
    for (int i = 0; i < 10; ++i) {
        truth::CheckedAnswer answer;
        answer.exact = i < 7    ? truth::ExactVerdict::separated
                       : i == 7 ? truth::ExactVerdict::touching
                                : truth::ExactVerdict::overlapping;
        answer.band.scale = 2;
        answer.error = i * 1e-15;
        answer.error_given = i * 1e-8;
        answer.witness_error = i * 1e-16;
        checked.push_back(answer);
    }
    checked[9].verdict_wrong = true;
    checked[8].distance_wrong = true;
    checked[4].in_band = true;
    return checked;
}

TEST(Error, IsTheWorstAndVerdictsAreCounted) {
    const auto checked = ten_answers();
    expect_values(error::figures(checked, {1000, 1500, 3, 2, 17, 5, 8}),
                  {{"checked", 10},
                   {"worst_error_stored", checked[9].error / 2},
                   {"worst_error_given", checked[9].error_given / 2},
                   {"wrong_verdicts", 1},
                   {"wrong_answers", 2},
                   {"verdicts_in_band", 1},
                   {"separated", 7},
                   {"touching", 1},
                   {"overlapping", 2},
                   {"fallbacks", 3},
                   {"cycles", 2},
                   {"refinements", 5},
                   {"escapes", 8},
                   {"mean_steps", 1.5},
                   {"max_steps", 17}});
}

TEST(Error, OfTheControlIsCountedOrSaidNotToBeAsked) {
    auto checked = ten_answers();
    EXPECT_FALSE(by_name(error::figures(checked, {})).at("control_disagreements").value);
    checked[4].control_disagrees = true;  // in the band
    checked[5].control_disagrees = true;
    checked[6].control_disagrees = false;
    expect_values(
        error::figures(checked, {}),
        {{"control_checked", 3}, {"control_disagreements", 2}, {"control_disagreements_outside_band", 1}});
}

/// Errors 1 to `count`, in no order: 17 has no divisor in common with the counts that are asked for.
std::vector<truth::CheckedAnswer> ranked_answers(std::size_t count) {
    std::vector<truth::CheckedAnswer> checked(count);
    for (std::size_t i = 0; i < count; ++i) {
        checked[i].band.scale = 1;
        checked[i].error_given = static_cast<double>(1 + i * 17 % count);
        checked[i].error = 1e9;
    }
    return checked;
}

TEST(Error, HasQuantilesOfTheGivenBodiesWhereThereAreEnoughAnswers) {
    // By hand: 0.5 x 1000 and 0.999 x 1000 steps above the least of 1001.
    const auto of_1001 = by_name(error::figures(ranked_answers(1001), {}));
    EXPECT_EQ(of_1001.at("p50_error_given").value, 501);
    EXPECT_DOUBLE_EQ(of_1001.at("p999_error_given").value.value_or(0), 1000);
    EXPECT_EQ(of_1001.at("worst_error_given").value, 1001);

    const auto of_1000 = by_name(error::figures(ranked_answers(1000), {}));
    const double p999 = of_1000.at("p999_error_given").value.value_or(0);
    EXPECT_TRUE(p999 > 998 && p999 < 1000) << p999 << ": it differs from the worst";

    const measure::Figure of_999 = by_name(error::figures(ranked_answers(999), {})).at("p999_error_given");
    EXPECT_FALSE(of_999.value);
    EXPECT_NE(of_999.reason.find("999 checked distances"), std::string::npos) << of_999.reason;
    EXPECT_NE(of_999.remedy.find("1000"), std::string::npos) << of_999.remedy;

    std::vector<truth::CheckedAnswer> mostly_without = ranked_answers(1200);
    for (std::size_t i = 300; i < mostly_without.size(); ++i) mostly_without[i].has_distance = false;
    EXPECT_FALSE(by_name(error::figures(mostly_without, {})).at("p999_error_given").value);
}

TEST(Error, OfNoAnswerIsNoNumber) {
    EXPECT_FALSE(by_name(error::figures({}, {}))["worst_error_stored"].value);
}

}  // namespace
}  // namespace edgewise::probes
