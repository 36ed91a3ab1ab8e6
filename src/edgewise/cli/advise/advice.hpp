// SPDX-License-Identifier: MIT
//
// An advice: what was asked, what was looked at and raced, what was predicted, and what would change it; and
// its two forms. The keys of its JSON are those of the report's answer.
//
// The fastest cells of an advice in processes of their own, one after the other: an interval within one
// process does not know what differs between processes. Each process is a sweep of this program into a store
// of its own, and the ranker of `reports` ranks these stores' cells. Where machines were named, the first
// process models their caches; the next also times a few bodies that fit the cache; the last models this
// machine.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/studies/advise/screen.hpp"

namespace edgewise::cli {

struct RaceOptions {
    std::vector<std::string> machines;  ///< as for choose_machines, to model their caches; host is added
    double seconds = 20;  ///< a process that has not ended by then is ended, and counts for nothing
};

/// A race that was run.
struct Race {
    Race() = default;
    Race(Race&&) = default;  ///< and no copy: the answer points into the stores
    Race& operator=(Race&&) = default;

    std::vector<reports::ReportData> stores;  ///< one for each process that came to its end
    reports::Answer answer;                   ///< its only scene is the case; none: nothing was timed
    std::map<std::string, studies::advise::CacheCost> caches;  ///< by the cell's name
    std::vector<double> latencies_ns;  ///< here, beyond the first level: what predictions are of
    std::string problem;               ///< why the next process did not come to its end; empty: there is none

    [[nodiscard]] int processes() const { return static_cast<int>(stores.size()); }
    /// Each null where there is none.
    [[nodiscard]] const reports::SceneRanking* scene() const;
    [[nodiscard]] const reports::RankedCell* taken() const;
    [[nodiscard]] const studies::advise::CacheCost* caches_of(const reports::RankedCell& cell) const;
    /// The fastest cell within the error by the prediction for that machine.
    [[nodiscard]] const reports::RankedCell* fastest_predicted(const std::string& machine) const;
    /// Returns true if the fastest by the prediction for this machine is in the tie set; null: no prediction.
    [[nodiscard]] std::optional<bool> prediction_held() const;
};

/// The number of processes and rounds expected to fit the seconds, by the time of the first look.
[[nodiscard]] Race run_race(const studies::advise::CaseAsked& asked,
                            const std::vector<studies::advise::ScreenedCell>& cells,
                            const RaceOptions& options);

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

[[nodiscard]] std::string advice_text(const Advice& advice);
[[nodiscard]] nlohmann::json advice_json(const Advice& advice);

}  // namespace edgewise::cli
