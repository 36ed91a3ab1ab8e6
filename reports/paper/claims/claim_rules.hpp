// SPDX-License-Identifier: MIT
//
// How evidence becomes a verdict: a claim has parts, each a number with the band that it is wanted in. The
// whole interval inside: met; the whole interval outside: missed; else undecided.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "edgewise/reports/paper/claims/claims.hpp"
#include "edgewise/reports/paper/claims/evidence.hpp"

namespace edgewise::reports {

/// What a number must be, in numbers and in words.
struct WantedBand {
    double low = 0, high = 0;
    std::string description;  ///< empty: nothing is wanted, the number is only shown
};

[[nodiscard]] WantedBand at_least(double bound);
[[nodiscard]] WantedBand at_most(double bound);
[[nodiscard]] WantedBand more_than(double bound);
[[nodiscard]] WantedBand less_than(double bound);
[[nodiscard]] WantedBand between(double low, double high);
[[nodiscard]] WantedBand only_shown();

struct ClaimPart {
    std::string label;
    Evidence ours;
    WantedBand wanted;
    std::string unit = {};  ///< the claim's where empty
};

/// The claim's entry in claims.json, with the verdict that its parts give. Throws std::out_of_range when
/// there is no such entry.
[[nodiscard]] Claim judge_claim(const std::string& id, const std::vector<ClaimPart>& parts);

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
[[nodiscard]] Claim judge_variants(const std::string& id, const std::string& assumption,
                                   const std::vector<ClaimVariant>& variants);
/// The variants of both readings.
[[nodiscard]] Claim both_readings(const std::string& id,
                                  const std::function<PartList(const TimeStepReading&)>& parts);

}  // namespace edgewise::reports
