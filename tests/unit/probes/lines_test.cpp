// SPDX-License-Identifier: MIT
//
// Means from known sums.
#include "edgewise/probes/lines.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

TEST(Lines, AreMeansOverQueries) {
    measure::LinesTouched touched = {10, 400, 6400, 150};
    auto found = by_name(lines::figures(touched));
    EXPECT_EQ(found["lines_per_query"].value, 15);
    EXPECT_EQ(found["line_bytes_per_query"].value, 15 * 64);
    EXPECT_EQ(found["read_bytes_per_query"].value, 640);
    EXPECT_EQ(found["reads_per_query"].value, 40);
    touched = {};
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query"].value);
    touched.queries = 10;
    EXPECT_FALSE(by_name(lines::figures(touched))["lines_per_query"].value) << "the loader was told nothing";
    EXPECT_EQ(by_name(lines::figures(touched, true))["lines_per_query"].value, 0) << "bounds told all";
}

}  // namespace
}  // namespace edgewise::probes
