// SPDX-License-Identifier: MIT
//
// Must not compile with -ffast-math:
// error: .*Edgewise needs NaN and infinity
#include "edgewise/geometry/vec.hpp"
