// SPDX-License-Identifier: MIT
//
// The cost of keeping pairs: every entry is made once and found again, and what is told is a time.
#include "edgewise/probes/pairs.hpp"

#include <gtest/gtest.h>

#include <set>

namespace edgewise::probes {
namespace {

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
