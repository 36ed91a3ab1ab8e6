// SPDX-License-Identifier: MIT
//
// Counts and numbers as users write them: on the command line, in plans, in scene files. All are read in one
// way: decimal digits within a range, and a one-line error that names both. Signs, blanks, hexadecimal and an
// empty text are not counts, so that no slip becomes a large number.
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"

namespace edgewise::input {

/// Range of a count: from `least` to `most`, both allowed.
struct CountRange {
    std::uint64_t least = 0, most = UINT64_MAX;
    std::string_view unit = "";  ///< of what it counts, such as "queries"
};

// Limits of one run. A larger number is a slip, or needs several runs.
inline constexpr CountRange queries_range{1, 100'000'000, "queries"};  ///< poses take 224 bytes each
inline constexpr CountRange queries_or_none{0, 100'000'000, "queries"};
inline constexpr CountRange rounds_range{1, 1'000'000, "rounds"};
inline constexpr CountRange cases_range{1, 10'000'000, "cases"};  ///< per hard family, kept in memory
inline constexpr CountRange cases_or_none{0, 10'000'000, "cases"};
inline constexpr CountRange bodies_or_none{0, 100'000, "bodies"};
inline constexpr CountRange steps_or_none{0, 1'000'000, "steps"};
inline constexpr CountRange seed_range{};

/// Parses a count of digits only: "30000". The error text names no place: "'-1' wants a whole number of
/// queries, 1 to 100".
[[nodiscard]] Result<std::uint64_t> parse_count(std::string_view text, const CountRange& range);

/// Returns a count from a JSON number without a fraction: 30000, or 3e4.
[[nodiscard]] Result<std::uint64_t> count_from(const nlohmann::json& value, const CountRange& range);

/// Range of a number: from `least` to `most`, both allowed; without `least` itself if `is_above`.
struct NumberRange {
    double least = std::numeric_limits<double>::lowest(), most = std::numeric_limits<double>::max();
    std::string_view unit = "";  ///< of what it is a number, such as "seconds"
    bool is_above = false;
};

inline constexpr NumberRange any_number{}, from_0{0}, above_0{.least = 0, .is_above = true};

/// A finite decimal number: "0.5", "-1e-3". The error names no place: "'nan' wants a decimal number of
/// seconds, 5 to 3600".
[[nodiscard]] Result<double> parse_number(std::string_view text, const NumberRange& range = any_number);

}  // namespace edgewise::input
