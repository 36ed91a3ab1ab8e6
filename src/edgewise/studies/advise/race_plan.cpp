// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/race_plan.hpp"

#include <algorithm>

namespace edgewise::studies::advise {

double race_seconds(const RaceCost& cost, const RacePlan& plan) {
    return (plan.processes + 1) * (cost.process + plan.rounds * cost.round) + cost.traces;
}

RacePlan race_within(double seconds, const RaceCost& cost) {
    for (RacePlan plan = whole_race; plan.processes >= least_race.processes; --plan.processes) {
        for (plan.rounds = whole_race.rounds; plan.rounds >= least_race.rounds; --plan.rounds)
            if (race_seconds(cost, plan) <= seconds) return plan;
    }
    return least_race;
}

bool TimeLimit::begin_piece() {
    const double now = clock_();
    if (begun_) longest_ = std::max(longest_, now - *begun_);
    begun_ = now;
    return now + longest_ < end_;
}

}  // namespace edgewise::studies::advise
