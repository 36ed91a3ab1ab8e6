// SPDX-License-Identifier: MIT
//
// A number that a claim is judged by: with the 95 % interval that holds it, or with the reason why there is
// none. Arithmetic on intervals is conservative: a quotient's runs from low over high to high over low, as if
// both errors met at their worst.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace edgewise::reports {

struct Evidence {
    std::optional<double> value;
    double low = 0, high = 0;  ///< both the value where it is exact
    std::string missing = {};  ///< why there is no value

    [[nodiscard]] bool has_interval() const { return value && low < high; }
};

[[nodiscard]] Evidence exact_evidence(double value);
[[nodiscard]] Evidence interval_evidence(double value, double low, double high);
[[nodiscard]] Evidence no_evidence(const std::string& why);

/// None where either is missing, or where the divisor's interval reaches 0.
[[nodiscard]] Evidence quotient(const Evidence& a, const Evidence& b);
[[nodiscard]] Evidence sum(const Evidence& a, const Evidence& b);
/// Returns the evidence, raised to `least` if it is smaller: for counts that are divisors and may be 0.
[[nodiscard]] Evidence no_less_than(Evidence a, double least);

/// Returns the geometric mean; none where a value is missing, or with the given reason for an empty list.
[[nodiscard]] Evidence geometric_mean(const std::vector<Evidence>& all,
                                      const std::string& when_none = "no such cell is stored");
[[nodiscard]] Evidence smallest(const std::vector<Evidence>& all,
                                const std::string& when_none = "no such cell is stored");
[[nodiscard]] Evidence largest(const std::vector<Evidence>& all,
                               const std::string& when_none = "no such cell is stored");

/// "0.93 [0.91, 0.95] ns"; the unit 1 is not written.
[[nodiscard]] std::string evidence_text(const Evidence& evidence, const std::string& unit);

}  // namespace edgewise::reports
