// SPDX-License-Identifier: MIT
//
// Probes on known numbers: medians, means, shares and slopes.
#include <gtest/gtest.h>

#include <set>

#include "edgewise/probes/build.hpp"
#include "edgewise/probes/bytes.hpp"
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

}  // namespace

}  // namespace edgewise::probes
