// SPDX-License-Identifier: MIT
//
// A pair as text that others can use: a case line of ours, and C++ for FCL and Bullet. Numbers are the
// shortest that read back the same.
#pragma once

#include <optional>
#include <string>

#include "edgewise/scene/case_file.hpp"

namespace edgewise::scene {

/// What an answer to the pair should be, for a test.
struct ExpectedAnswer {
    double distance = 0;
    std::optional<double> depth;  ///< in contact
};

/// One line, as CaseReader and the corpus take it: `source` says where the pair is from. Without an expected
/// answer where that is for the reader to find.
[[nodiscard]] std::string case_line(const Case& pair, const std::string& source,
                                    const std::optional<ExpectedAnswer>& expected = std::nullopt);

/// A test of googletest for FCL's default solver, with the hulls' faces. Fails for flat bodies, of which FCL
/// has none.
[[nodiscard]] Result<std::string> fcl_test(const Case& pair, const ExpectedAnswer& expected);

/// The same for Bullet's btGjkPairDetector.
[[nodiscard]] std::string bullet_test(const Case& pair, const ExpectedAnswer& expected);

}  // namespace edgewise::scene
