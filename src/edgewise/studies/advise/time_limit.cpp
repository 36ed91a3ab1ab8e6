// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/time_limit.hpp"

#include <algorithm>

namespace edgewise::studies::advise {

bool TimeLimit::begin_piece() {
    const double now = clock_();
    if (begun_) longest_ = std::max(longest_, now - *begun_);
    begun_ = now;
    return now + longest_ < end_;
}

}  // namespace edgewise::studies::advise
