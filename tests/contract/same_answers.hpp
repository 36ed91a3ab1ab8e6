// SPDX-License-Identifier: MIT
//
// Answers of two tables to the same questions, compared to the bit.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise {

inline void expect_same_bits(const Distance& a, const Distance& b) {
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.cycles, b.cycles);
    EXPECT_EQ(a.fallbacks, b.fallbacks);
    EXPECT_EQ(std::memcmp(&a.distance, &b.distance, sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.point_a.data(), b.point_a.data(), 3 * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.point_b.data(), b.point_b.data(), 3 * sizeof(double)), 0);
}

/// Answers of cold and warm queries, all poses in turn.
template <class Algorithm, class T>
[[nodiscard]] std::vector<Distance> answers(const T& a, const T& b,
                                            const std::vector<Transform<double>>& poses) {
    using Pair = typename Algorithm::template Pair<T, T>;
    Pair warm(a, b);
    std::vector<Distance> result;
    for (const Transform<double>& pose : poses) {
        Pair cold(a, b);
        result.push_back(Algorithm::query(a, b, pose, cold));
        result.push_back(Algorithm::query(a, b, pose, warm));
    }
    return result;
}

}  // namespace edgewise
