// SPDX-License-Identifier: MIT
//
// Medians and ratios from known times.
#include "edgewise/probes/build.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

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

}  // namespace
}  // namespace edgewise::probes
