// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/frame_trace.hpp"

#include "edgewise/bench/trace/trace_names.hpp"

namespace edgewise::bench {

namespace {

/// From elements of arrays to addresses.
struct TracedTouches {
    const TracePlaces& places;
    measure::TraceListener& listener;

    void read(BroadPhaseArray array, std::size_t i, ElementPart part) const {
        note(array, i, part, measure::AccessKind::read);
    }
    void write(BroadPhaseArray array, std::size_t i, ElementPart part) const {
        note(array, i, part, measure::AccessKind::write);
    }

    void note(BroadPhaseArray array, std::size_t i, ElementPart part, measure::AccessKind kind) const {
        const auto which = static_cast<std::size_t>(array);
        listener.on_access({places.broad_phase[which] + i * TracePlaces::element_bytes[which] + part.offset,
                            static_cast<std::uint32_t>(part.bytes), kind,
                            static_cast<std::uint8_t>(broad_phase_field + which),
                            static_cast<std::uint8_t>(TraceStep::broad_phase), measure::TraceSide::scene});
    }
};

}  // namespace

void FrameTrace::before(std::size_t query) {
    for (; next_ < workload_.frames.size() && workload_.frames[next_].first_query <= query; ++next_) {
        end_before(query);
        static_cast<void>(run(workload_.frames[next_]));
    }
}

std::size_t FrameTrace::run(const scene::Frame& frame) {
    if (frame.boxes.empty()) return 0;
    if (frame.starts_anew || !broad_phase_) broad_phase_.emplace(frame.boxes.size());
    TracedTouches touches{places_, listener_};
    for (std::size_t body = 0; body < frame.boxes.size(); ++body)
        touches.write(BroadPhaseArray::boxes, body, {0, sizeof(Aabb)});
    return broad_phase_->update(frame.boxes, touches).size();
}

}  // namespace edgewise::bench
