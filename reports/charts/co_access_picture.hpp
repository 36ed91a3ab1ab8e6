// SPDX-License-Identifier: MIT
//
// Which fields are read together, as a picture: a matrix of squares, above the diagonal by the same query,
// below it by the same step. One colour, the more of it the more often, and text in the colour of its
// surroundings: it reads on white and on black.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace edgewise::reports {

struct CoAccessField {
    std::string name, record;
};

/// Parts from 0 to 1 of what read either field that read both, at [a][b] and [b][a]; at [a][a] of queries or
/// steps that read the field.
using CoAccessParts = std::vector<std::vector<double>>;

/// Returns the matrix as SVG. Fields of one record are adjacent and framed.
[[nodiscard]] std::string draw_co_access(const std::string& title, std::span<const CoAccessField> fields,
                                         const CoAccessParts& by_query, const CoAccessParts& by_step);

}  // namespace edgewise::reports
