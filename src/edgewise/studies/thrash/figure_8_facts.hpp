// SPDX-License-Identifier: MIT
//
// The four facts that figure 8 states (section 4), each a number and a rule. The time axes of figures 7 and 8
// have marks at their ends only, 1e-4 s and 1.2e-3 s: a maximum is known to a factor of two at best.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace edgewise::studies::thrash {

/// The axis of speed of figures 7 and 8, rad per second.
inline constexpr std::array<double, 7> speeds = {1, 2, 3, 4, 5, 6, 7};

/// ns per query at each of the speeds.
using SpeedCurve = std::array<double, speeds.size()>;

struct Figure8 {
    SpeedCurve vclip_8, vclip_38, vclip_386, gjk_8, gjk_38, gjk_386;
};

enum class Fact : std::uint8_t { rises, takes_as_long, spares_gjk, erratic };
inline constexpr std::array<std::string_view, 4> fact_names = {"rises", "takes_as_long", "spares_gjk",
                                                               "erratic"};

inline constexpr double least_rise = 6, most_rise = 24;             ///< half and double of 12
inline constexpr double least_top_ns = 0.6e6, most_top_ns = 1.2e6;  ///< of an axis that ends at 1.2e-3 s
inline constexpr double most_gjk_rise = 2;
inline constexpr double least_fall = 1.2;  ///< as the claim vclip_erratic_at_386 has it

struct FactScore {
    double rise = 0;             ///< V-Clip's longest at 386 vertices over its longest at 38
    double top_ns = 0;           ///< V-Clip's longest at 386
    double gjk_rise = 0;         ///< GJK's longest, likewise
    double gjk_rise_from_8 = 0;  ///< shown, not scored
    double fall = 0;             ///< the largest of V-Clip at 386 from one speed to a faster one, as a ratio
    double gjk_fall = 0;
    std::array<bool, 4> holds{};

    [[nodiscard]] int count() const { return holds[0] + holds[1] + holds[2] + holds[3]; }
    /// Bit i: fact i holds.
    [[nodiscard]] unsigned mask() const {
        return holds[0] * 1U + holds[1] * 2U + holds[2] * 4U + holds[3] * 8U;
    }
};

/// Returns the largest ratio of a time to the time at a faster speed; 1 or less if the time never falls.
[[nodiscard]] double largest_fall(const SpeedCurve& curve);

[[nodiscard]] FactScore score(const Figure8& figure);

}  // namespace edgewise::studies::thrash
