// SPDX-License-Identifier: MIT
//
// Counts the reads of a trace's queries: vertices, lines, and how often GJK seeks a support point. All
// queries count, those that start cold too, since whole passes are what Callgrind counts.
#pragma once

#include <cstdint>
#include <optional>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"

namespace edgewise::studies {

class ReadCounter final : public measure::TraceListener {
  public:
    /// `warm`: pairs keep their cache, so that a query that does not count started cold; else all do.
    explicit ReadCounter(bool warm) : warm_(warm) {}

    void on_access(const measure::TracedAccess& access) override {
        lines_.on_access(access);
        if (access.side == measure::TraceSide::scene) return;
        if (access.field == static_cast<std::uint8_t>(Field::vertex)) vertex_bytes_ += access.bytes;
        const bool iterates = access.step == static_cast<std::uint8_t>(bench::TraceStep::gjk_iteration);
        if (!iterates) return;
        supports_ += last_side_ != access.side;
        last_side_ = access.side;
    }

    void on_query_end(bool counts) override {
        lines_.on_query_end(true);
        if (!warm_ || !counts) supports_ += 2;
        last_side_.reset();
    }

    /// Sums over the queries.
    [[nodiscard]] std::uint64_t vertex_bytes() const { return vertex_bytes_; }
    [[nodiscard]] std::uint64_t lines() const { return lines_.sums().all.lines; }
    /// Returns GJK's support searches: its iterations seek points on A and on B in turn, so each change of
    /// side is a search; a cold query starts at a point of each.
    [[nodiscard]] std::uint64_t supports() const { return supports_; }

  private:
    bool warm_;
    measure::LineCounter lines_;
    std::uint64_t vertex_bytes_ = 0, supports_ = 0;
    std::optional<measure::TraceSide> last_side_;
};

}  // namespace edgewise::studies
