// SPDX-License-Identifier: MIT
//
// How wrong an answer may be, by what kind of pair it answers.
#pragma once

#include "judged.hpp"
#include "stored_bodies.hpp"
#include "table_under_test.hpp"

namespace edgewise {

/// What may be expected of an answer.
enum class Class {
    plain,     ///< everything
    parallel,  ///< the right distance to within a tilt that rounding hides
};
inline constexpr std::size_t classes = 2;

/// Two edges (or an edge and a face) that are parallel but for a little tilt have a direction of shortest
/// distance that is only known to eps x size / gap, times 64 for V-Clip's dead bands; either algorithm may
/// then stop at the wrong end of an edge, and be off by that. Up to this gap (in sizes) it is more than the
/// verified error.
inline constexpr double parallel_reach =
    64 * compute_eps<Table> /
    (compute_eps<Table> > Tolerance<double>::eps ? verified_error_single : verified_error_double);

inline Class classify(const CheckedPair& checked) {
    const bool close = !checked.separated() || checked.exact.distance < parallel_reach * checked.size;
    return close && checked.pair.relation != Relation::generic ? Class::parallel : Class::plain;
}

inline constexpr double verified_error =
    compute_eps<Table> > Tolerance<double>::eps ? verified_error_single : verified_error_double;

constexpr double error_allowed(Class answer) {
    const bool single = compute_eps<Table> > Tolerance<double>::eps;
    if (answer == Class::parallel) return single ? 1e-3 : 2e-6;
    return single ? verified_error_single : verified_error_double;
}

}  // namespace edgewise
