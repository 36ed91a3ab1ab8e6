// SPDX-License-Identifier: MIT
//
// The bar over the chapters, by which their charts and tables show one scene, body, algorithm or precision.
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Hidden until the scripts run.
[[nodiscard]] std::string filter_bar_html(const ReportData& data);

}  // namespace edgewise::reports
