// SPDX-License-Identifier: MIT
//
// A pair as text that others can use: a case line of ours, and C++ for FCL and Bullet. Numbers are the
// shortest that read back the same. Also a pair in words, so that a user can check that it was read as meant.
#pragma once

#include <optional>
#include <string>

#include "edgewise/scene/case_file.hpp"

namespace edgewise::scene {

/// A case to fill in, on one line, as CaseReader takes it.
inline constexpr const char* case_template =
    R"({"id": "1", "a": {"vertices": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, )"
    R"("b": {"vertices": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, )"
    R"("pose_a": {"R": [[1,0,0], [0,1,0], [0,0,1]], "t": [0,0,0]}, )"
    R"("pose_b": {"R": [[0,-1,0], [1,0,0], [0,0,1]], "t": [3,0,0]}, )"
    R"("note": "each body in its own frame; in the world R v + t"})";

/// A rotation by an angle about an axis.
struct Turn {
    Vec3d axis;      ///< unit; any for no turn
    double degrees;  ///< 0 to 180
};
[[nodiscard]] Turn turn_of(const Mat3d& rotation);

/// "8 vertices from (0, 0, 0) to (1, 1, 2), extent 1 x 1 x 2"
[[nodiscard]] std::string text_of(const CaseBody& body);
/// "at the identity", "at (1.5, 0, 0), turned by 45 degrees about (0, 0, 1)"
[[nodiscard]] std::string text_of(const Pose& pose);

/// What an answer to the pair should be, for a test.
struct ExpectedAnswer {
    double distance = 0;
    std::optional<double> depth;  ///< in contact
};

/// One line, as CaseReader and the corpus take it: `source` says where the pair is from. Without an expected
/// answer where that is for the reader to find.
[[nodiscard]] std::string case_line(const Case& pair, const std::string& source,
                                    const std::optional<ExpectedAnswer>& expected = std::nullopt);

/// fcl_test.txt and bullet_test.txt: the tests, with names in braces for what differs.
extern const char *const fcl_test_text, *const bullet_test_text;

/// Returns a googletest test for FCL's default solver, with the hulls' faces. Fails for flat bodies, because
/// FCL has none.
[[nodiscard]] Result<std::string> fcl_test(const Case& pair, const ExpectedAnswer& expected);

/// Returns a test for Bullet's btGjkPairDetector.
[[nodiscard]] std::string bullet_test(const Case& pair, const ExpectedAnswer& expected);

}  // namespace edgewise::scene
