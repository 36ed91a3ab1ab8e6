// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/callgrind_region.hpp"

#include <valgrind/callgrind.h>

namespace edgewise::measure {

bool CallgrindRegion::available() { return true; }
CallgrindRegion::CallgrindRegion() { CALLGRIND_TOGGLE_COLLECT; }
CallgrindRegion::~CallgrindRegion() { CALLGRIND_TOGGLE_COLLECT; }

}  // namespace edgewise::measure
