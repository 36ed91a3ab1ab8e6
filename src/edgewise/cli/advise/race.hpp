// SPDX-License-Identifier: MIT
//
// The finalists of an advice in processes of their own, one after the other: what differs between processes
// is what an interval within one does not know. Each is a sweep of this program into a store of its own.
// Where machines were named, the first models their caches; the next times a few bodies that fit the cache,
// too; the last models this machine.
#pragma once

#include <string>
#include <vector>

#include "edgewise/studies/advise/finals.hpp"
#include "edgewise/studies/advise/race_plan.hpp"
#include "edgewise/studies/advise/screen.hpp"

namespace edgewise::cli {

struct RaceOptions {
    std::vector<std::string> machines;  ///< whose caches are modelled, as for choose_machines; host is added
    double seconds = 20;  ///< a process that has not ended by then is ended, and counts for nothing
};

/// As many processes and rounds as are expected to fit the seconds, by what the first look took. `problem` of
/// the finals says why there are fewer processes.
[[nodiscard]] studies::advise::Finals run_race(const studies::advise::CaseAsked& asked,
                                               const std::vector<studies::advise::ScreenedCell>& finalists,
                                               const RaceOptions& options);

}  // namespace edgewise::cli
