// SPDX-License-Identifier: MIT
//
// Must give a warning where the processor has fused products and no -DEDGEWISE_CONTRACTION_KNOWN:
// error: .*fused products change the last bits
#include "edgewise/geometry/vec.hpp"
