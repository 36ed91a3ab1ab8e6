// SPDX-License-Identifier: MIT
//
// Observes an algorithm at work: notified of every step before it is taken, so that what a step reads can be
// booked under it. The default sees nothing and costs nothing.
#pragma once

#include <cstdint>

#include "edgewise/geometry/feature.hpp"

namespace edgewise {

struct NoObserver {
    /// V-Clip: the state on features of these kinds comes next, or the proof that they are closest.
    static void visit(FeatureKind, FeatureKind) {}
    /// V-Clip: its answer is not trusted, GJK answers next.
    static void ask_gjk() {}
    /// GJK: an iteration comes next, on the members (bit i: point i) of the simplex that were accepted last.
    static void iterate(std::uint8_t /*members*/) {}
};

}  // namespace edgewise
