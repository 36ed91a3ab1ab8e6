// SPDX-License-Identifier: MIT
//
// What a caller may give away of an answer for speed or robustness, and how it is found. Nothing is given
// away unless asked: both tolerances default to "as exact as the type allows". The paper's (section 3.4) are
// of these two kinds.
#pragma once

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/sub_distance_solver.hpp"

namespace edgewise {

struct QueryOptions {
    /// Bodies as near as this or nearer are touching, in the bodies' own unit.
    double contact_tolerance = 0;
    /// GJK ends when the squared distance is known to this relative width: the duality gap |v|^2 - <v, w>
    /// over |v|^2. The distance is then too large by at most this part of itself. V-Clip has no such thing.
    double gap_tolerance = 0;
    /// Only the verdict is wanted: GJK ends as soon as a direction separates the bodies, by more than the
    /// contact tolerance, and the distance of separated bodies is then an upper bound. V-Clip knows its
    /// verdict no sooner than its distance.
    bool verdict_only = false;
    /// V-Clip's: a cycle, and an answer that rounding may have chosen, is GJK's to give. Else V-Clip is raw,
    /// as published: what it ended with stands, right or wrong. Its loops are not inlined then: it is there
    /// to be judged, not timed.
    bool hardened = true;
    /// GJK's; V-Clip has none of its own, and where it asks GJK that solves as by default.
    SubDistanceSolver sub_distance = SubDistanceSolver::cofactors;
};

/// An answer as the options ask for it. A distance within the tolerance stays as found: for GJK, which
/// stops as soon as it knows that much, an upper bound.
[[nodiscard]] inline Distance within(const QueryOptions& options, Distance answer) {
    if (answer.status == Status::separated && answer.distance <= options.contact_tolerance)
        answer.status = Status::touching;
    return answer;
}

}  // namespace edgewise
