// SPDX-License-Identifier: MIT
#include "edgewise/studies/parts/allowed_errors.hpp"

#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::studies {

AllowedErrors allowed_errors(const bench::TableType& type, const std::string& algorithm) {
    const bool single = type.eps > Tolerance<double>::eps;
    const bool rounded_planes = type.rounded_planes && algorithm == "vclip";
    return {single || rounded_planes ? verified_error_single : verified_error_double,
            single ? verified_error_single : verified_depth_error_double};
}

}  // namespace edgewise::studies
