// SPDX-License-Identifier: MIT
//
// The chapter on which fields of a record travel together.
#pragma once

#include <optional>

#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {

/// Nothing where the fields run was not made.
[[nodiscard]] std::optional<Chapter> fields_chapter(const ReportData& data);

}  // namespace edgewise::reports
