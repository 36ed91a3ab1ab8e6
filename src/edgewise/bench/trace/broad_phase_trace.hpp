// SPDX-License-Identifier: MIT
//
// The broad phase of a scene's frames once more, told to a trace's listener. What it finds is the scene's own
// list of queries; here only what it reads and writes matters.
#pragma once

#include <optional>

#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

class BroadPhaseTrace {
  public:
    BroadPhaseTrace(const TracePlaces& places, measure::TraceListener& listener)
        : places_(places), listener_(listener) {}

    /// Frames in order. Their boxes are written first, as whoever moved the bodies does. Returns how many
    /// pairs were near.
    std::size_t run(const scene::Frame& frame);

  private:
    const TracePlaces& places_;
    measure::TraceListener& listener_;
    std::optional<SweepAndPrune> broad_phase_;
};

}  // namespace edgewise::bench
