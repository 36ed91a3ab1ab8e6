// SPDX-License-Identifier: MIT
//
// Frames of a workload in the order of its queries: the broad phase of each frame runs again and reports to a
// trace's listener before the frame's first query, and the frame's end follows its last one. The scene's own
// list of queries holds the pairs found; here only reads and writes matter.
#pragma once

#include <optional>

#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

class FrameTrace {
  public:
    FrameTrace(const scene::Workload& workload, const TracePlaces& places, measure::TraceListener& listener)
        : workload_(workload), places_(places), listener_(listener) {}

    /// Call before each query, in order.
    void before(std::size_t query);
    /// Call after the last query that is followed; `query`: the next one. A frame that is cut does not end.
    void end_before(std::size_t query) const {
        const bool is_last = next_ == workload_.frames.size();
        const std::size_t end = is_last ? workload_.queries.size() : workload_.frames[next_].first_query;
        if (next_ > 0 && query >= end) listener_.on_frame_end();
    }
    /// Frames in order. Their boxes are written first, as whoever moved the bodies does. Returns how many
    /// pairs were near.
    std::size_t run(const scene::Frame& frame);

  private:
    const scene::Workload& workload_;
    const TracePlaces& places_;
    measure::TraceListener& listener_;
    std::optional<SweepAndPrune> broad_phase_;
    std::size_t next_ = 0;
};

}  // namespace edgewise::bench
