// SPDX-License-Identifier: MIT
//
// Observes an algorithm at work: notified of every step before it is taken, so that reads are booked under
// their step. The default does nothing and costs nothing.
#pragma once

#include <cstdint>
#include <type_traits>

#include "edgewise/geometry/feature.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

struct NoObserver {
    /// V-Clip: next comes the state on two features of this kind, or the proof that they are closest.
    static void visit(FeatureKind, FeatureKind) {}
    /// V-Clip: its answer is not trusted, GJK answers next.
    static void ask_gjk() {}
    /// GJK: next comes a search in singles, which reads all vertices once.
    static void search() {}
    /// GJK: next comes an iteration, on the accepted members (bit i: point i) of the last simplex.
    static void iterate(std::uint8_t /*members*/) {}
};

/// True if a trace or an observer sees the steps of a run: such a run is never timed.
template <class Table, class Observer>
inline constexpr bool is_looked_at =
    is_traced<Table> || !std::is_same_v<std::remove_cvref_t<Observer>, NoObserver>;

}  // namespace edgewise
