// SPDX-License-Identifier: MIT
//
// The start of EPA, for either algorithm: from the state that the last distance query of the pair left.
#pragma once

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/algorithms/vclip/fallback.hpp"

namespace edgewise {

template <SupportTable TableA, SupportTable TableB>
[[nodiscard]] const SimplexPair<TableA, TableB>& simplex_of(const TableA&, const TableB&,
                                                            const SimplexPair<TableA, TableB>& pair) {
    return pair;
}

template <FeatureTable TableA, FeatureTable TableB>
[[nodiscard]] SimplexPair<TableA, TableB> simplex_of(const TableA& a, const TableB& b,
                                                     const FeaturePair<TableA, TableB>& pair) {
    if (!pair.belongs_to(a, b)) return SimplexPair<TableA, TableB>(a, b);
    const Features<TableA, TableB> last = pair.start(a, b);
    return vclip::feature_simplex(a, last.a, b, last.b);
}

}  // namespace edgewise
