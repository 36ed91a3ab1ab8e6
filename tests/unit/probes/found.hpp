// SPDX-License-Identifier: MIT
//
// What a probe found, by name; and what every figure must keep: it is a finite number, or null with a reason.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
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

}  // namespace edgewise
