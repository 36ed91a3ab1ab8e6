// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/callgrind_region.hpp"

namespace edgewise::measure {

bool CallgrindRegion::available() { return false; }
CallgrindRegion::CallgrindRegion() = default;
CallgrindRegion::~CallgrindRegion() = default;

}  // namespace edgewise::measure
