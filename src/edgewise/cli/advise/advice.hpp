// SPDX-License-Identifier: MIT
//
// An advice: what was asked, what was looked at and raced, what was predicted, and what would change it; and
// its two forms. The keys of its JSON are those of the report's answer.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edgewise/cli/advise/finals.hpp"

namespace edgewise::cli {

struct Advice {
    studies::advise::CaseAsked asked;
    std::vector<std::string> assumed;   ///< inputs that nobody gave
    std::vector<std::string> machines;  ///< whose caches were asked about, as given
    studies::advise::Screen screen;
    Finals finals;
    /// With the tables shared the other way, a first look only: fastest first; empty: not looked at, or no
    /// such way.
    std::vector<studies::advise::ScreenedCell> other_tables;
    double seconds = 0;                  ///< that it took
    std::vector<std::string> not_asked;  ///< what was left out, and why
};

/// Measures it: a line to `say` for each step. Steps that would end after so many seconds are left out, and
/// named.
void measure_advice(Advice& advice, double seconds, const std::function<void(const std::string&)>& say);

[[nodiscard]] std::string advice_text(const Advice& advice);
[[nodiscard]] nlohmann::json advice_json(const Advice& advice);

/// Whether the fastest by the prediction is among those that tie; null where nothing was predicted.
[[nodiscard]] std::optional<bool> prediction_held(const Finals& finals);

/// What another question would change, a sentence each.
[[nodiscard]] std::vector<std::string> what_would_change(const Advice& advice);

/// The command that asks for exactly this.
[[nodiscard]] std::string advise_command(const Advice& advice);

}  // namespace edgewise::cli
