// SPDX-License-Identifier: MIT
//
// Times a scene's steps as an engine would take them, and their parts each alone.
#pragma once

#include "edgewise/bench/runner.hpp"
#include "edgewise/measure/step_costs.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::sweep {

/// Of a scene in time order whose frames have boxes and poses; of any other only the reason. Medians of a few
/// passes over all steps; the first step of a population, where nothing is known from before, is taken and
/// not counted.
[[nodiscard]] measure::StepCosts step_costs(const bench::Runner& runner, const scene::Workload& workload);

}  // namespace edgewise::sweep
