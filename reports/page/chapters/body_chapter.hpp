// SPDX-License-Identifier: MIT
//
// The chapter with heat on the body itself.
#pragma once

#include "edgewise/reports/body/body_heat.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {

[[nodiscard]] Chapter body_chapter(const Answer& answer, const ReportData& data);

}  // namespace edgewise::reports
