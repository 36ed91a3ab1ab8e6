// SPDX-License-Identifier: MIT
//
// The chapter on what changed since another store.
#pragma once

#include <string>

#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {

/// `other`: what the other store is called.
[[nodiscard]] Chapter compare_chapter(const StoreComparison& comparison, double slack,
                                      const std::string& other);

}  // namespace edgewise::reports
