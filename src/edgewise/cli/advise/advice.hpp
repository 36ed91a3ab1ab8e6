// SPDX-License-Identifier: MIT
//
// An advice: what was asked, what was looked at and raced, what was predicted, and what would change it; and
// its two forms. The keys of its JSON are those of the report's answer.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edgewise/cli/advise/race.hpp"

namespace edgewise::cli {

struct Advice {
    studies::advise::CaseAsked asked;
    std::string command;                ///< that asks for exactly this
    std::vector<std::string> assumed;   ///< inputs that were not given
    std::vector<std::string> machines;  ///< whose caches were asked about, as given
    studies::advise::Screen screen;
    Race race;
    /// With the tables shared the other way, a first look only: those that are not dropped, fastest first;
    /// empty: not looked at, or no such way.
    std::vector<studies::advise::ScreenedCell> other_tables;
    double seconds = 0;                  ///< that it took
    std::vector<std::string> left_out;   ///< what no time was left for; what the user named first
    std::vector<std::string> not_asked;  ///< what else was left out, and why
};

/// Sentences on what would change the advice; none where nothing is taken.
[[nodiscard]] std::vector<std::string> changes_of(const Advice& advice);

[[nodiscard]] std::string advice_text(const Advice& advice);
[[nodiscard]] nlohmann::json advice_json(const Advice& advice);

}  // namespace edgewise::cli
