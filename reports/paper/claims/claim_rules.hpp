// SPDX-License-Identifier: MIT
//
// How evidence becomes a verdict: a claim has parts, each a number with the band that it is wanted in. The
// whole interval inside: met; the whole interval outside: missed; else undecided.
//
// A number that a claim is judged by: with the 95 % interval that holds it, or with the reason why there is
// none. Arithmetic on intervals is conservative: a quotient's runs from low over high to high over low, as if
// both errors met at their worst.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/paper/claims/claims.hpp"

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

/// Returns the evidence times a number above 0.
[[nodiscard]] Evidence multiple(const Evidence& of, double factor);
/// Returns the geometric mean; none where a value is missing, or with the given reason for an empty list.
[[nodiscard]] Evidence geometric_mean(const std::vector<Evidence>& all,
                                      const std::string& when_none = "no such cell is stored");
[[nodiscard]] Evidence smallest(const std::vector<Evidence>& all,
                                const std::string& when_none = "no such cell is stored");
[[nodiscard]] Evidence largest(const std::vector<Evidence>& all,
                               const std::string& when_none = "no such cell is stored");

/// "0.93 [0.91, 0.95] ns"; the unit 1 is not written.
[[nodiscard]] std::string evidence_text(const Evidence& evidence, const std::string& unit);

/// What a number must be, in numbers and in words.
struct WantedBand {
    double low = 0, high = 0;
    std::string description;  ///< empty: nothing is wanted, the number is only shown
};

/// Reads the band of a claim's part; a part without one is only shown.
[[nodiscard]] WantedBand band_of(const nlohmann::ordered_json& part);

struct ClaimPart {
    std::string label;
    Evidence ours;
    WantedBand wanted;
    std::string unit = {};  ///< the claim's where empty
};

/// Reads an entry of claims.json: a claim without a verdict.
[[nodiscard]] Claim claim_of(const nlohmann::ordered_json& entry);

/// Returns the claim with the verdict that its parts give.
[[nodiscard]] Claim judge_claim(Claim claim, const std::vector<ClaimPart>& parts);

/// The paper gives speeds in radians per second and no time step. One turn per step is its fastest test ("up
/// to 2 pi rad in a discrete time step"), figure 6 ends at 12.57 = 4 pi rad/s: then a step is 1/2 s. A
/// simulation for the screen has steps of 1/60 s. Both readings are judged.
struct TimeStepReading {
    const char* name;
    double seconds;
};
inline constexpr TimeStepReading reading_60th{"at steps of 1/60 s", 1.0 / 60};
inline constexpr TimeStepReading reading_half{"at steps of 1/2 s", 0.5};

using PartList = std::vector<ClaimPart>;

/// One value of something that the paper does not say, and the evidence under it.
struct ClaimVariant {
    std::string name;
    PartList parts;
};
/// The verdict that all variants share; not measured, or else inconclusive, where one of them is; "depends
/// on: ASSUMPTION" where they decide otherwise. There must be some.
[[nodiscard]] Claim judge_variants(const Claim& text, const std::string& assumption,
                                   const std::vector<ClaimVariant>& variants);

}  // namespace edgewise::reports
