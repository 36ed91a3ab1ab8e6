// SPDX-License-Identifier: MIT
//
// Means from known sums.
#include "edgewise/probes/lines.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

TEST(Lines, AreMeansOverQueries) {
    measure::ByStart<measure::LinesTouched> touched{
        {10, 400, 6400, 150}, {4, 300, 4400, 110}, {6, 100, 2000, 40}};
    auto found = by_name(lines::figures(touched));
    EXPECT_EQ(found["lines_per_query"].value, 15);
    EXPECT_EQ(found["line_bytes_per_query"].value, 15 * 64);
    EXPECT_EQ(found["read_bytes_per_query"].value, 640);
    EXPECT_EQ(found["reads_per_query"].value, 40);
    EXPECT_EQ(found["lines_per_query.cold"].value, 27.5);
    EXPECT_EQ(found["reads_per_query.cold"].value, 75);
    EXPECT_EQ(found["lines_per_query.warm"].value, 40 / 6.0);
    EXPECT_EQ(found["read_bytes_per_query.warm"].value, 2000 / 6.0);
    touched.warm = {};
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query.warm"].value);
    EXPECT_EQ(by_name(lines::figures(touched))["lines_per_query.warm"].reason, "no query here starts warm");
    touched = {};
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query"].value);
    touched.all.queries = 10;
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query"].value) << "the loader was told nothing";
    EXPECT_EQ(by_name(lines::figures(touched, true))["lines_per_query"].value, 0) << "bounds told all";
}

}  // namespace
}  // namespace edgewise::probes
