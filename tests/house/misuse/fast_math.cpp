// SPDX-License-Identifier: MIT
//
// Must not compile with -ffast-math, with parts of it and with x87 arithmetic:
// error: .*Edgewise needs NaN and infinity
#include "edgewise/geometry/vec.hpp"
