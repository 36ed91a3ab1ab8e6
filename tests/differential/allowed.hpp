// SPDX-License-Identifier: MIT
//
// How wrong an answer may be, by what kind of pair it answers.
#pragma once

#include "judged.hpp"
#include "stored_bodies.hpp"

namespace edgewise {

/// What may be expected of an answer.
enum class Class {
    plain,     ///< everything
    parallel,  ///< the right distance to within a tilt that rounding hides
};
inline constexpr std::size_t classes = 2;

template <class Table>
inline constexpr bool computes_in_single = compute_eps<Table> > Tolerance<double>::eps;

template <class Table>
inline constexpr double verified_error = truth::allowed_errors(compute_eps<Table>).distance;

/// Two edges (or an edge and a face) that are parallel but for a little tilt have a direction of shortest
/// distance that is only known to eps x size / gap, times 64 for V-Clip's dead bands; either algorithm may
/// then stop at the wrong end of an edge, and be off by that. Up to this gap (in sizes) it is more than the
/// verified error.
template <class Table>
inline constexpr double parallel_reach = 64 * compute_eps<Table> / verified_error<Table>;

template <class Table>
Class classify(const CheckedPair& checked) {
    const bool close = !checked.separated() || checked.exact.distance < parallel_reach<Table> * checked.size;
    return close && checked.pair.relation != Relation::generic ? Class::parallel : Class::plain;
}

template <class Table>
constexpr double error_allowed(Class answer) {
    if (answer == Class::parallel) return computes_in_single<Table> ? 1e-3 : 2e-6;
    return verified_error<Table>;
}

}  // namespace edgewise
