// SPDX-License-Identifier: MIT
//
// Names scenes for people: the scene alone where it occurs with one set of parameters, else with the
// parameters that differ, e.g. "tumble (rotation_step 0.01)"; a value that most of its namesakes have goes
// without saying.
#pragma once

#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

void label_scenes(std::vector<ReportCell>& cells);

}  // namespace edgewise::reports
