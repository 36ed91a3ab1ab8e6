// SPDX-License-Identifier: MIT
//
// The figures of a probe by name. Every figure must be a finite number, or null with a reason.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise {

using Found = std::map<std::string, measure::Figure>;

inline Found by_name(const std::vector<measure::Figure>& figures) {
    Found found;
    for (const measure::Figure& figure : figures) {
        EXPECT_FALSE(found.contains(figure.name)) << figure.name << " twice";
        EXPECT_FALSE(figure.unit.empty()) << figure.name;
        EXPECT_NE(figure.value.has_value(), !figure.reason.empty())
            << figure.name << " is a number or null with a reason";
        EXPECT_TRUE(std::isfinite(figure.value.value_or(0))) << figure.name;
        found[figure.name] = figure;
    }
    return found;
}

/// Expects a figure for each name in `values`, with its value; without a value: null with a reason.
inline void expect_values(const std::vector<measure::Figure>& figures,
                          const std::map<std::string, std::optional<double>>& values) {
    const Found found = by_name(figures);
    for (const auto& [name, value] : values) EXPECT_EQ(found.at(name).value, value) << name;
}

}  // namespace edgewise
