// SPDX-License-Identifier: MIT
//
// When something was measured, for the store.
#pragma once

#include <string>

namespace edgewise::measure {

/// Now, as "2026-01-31T23:59:59Z" (ISO 8601, UTC).
[[nodiscard]] std::string utc_time();

}  // namespace edgewise::measure
