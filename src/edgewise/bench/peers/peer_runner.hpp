// SPDX-License-Identifier: MIT
//
// A peer as a runner: same bodies, same poses, same clock and same checks as a table type of Edgewise. It has
// no traces and no pieces of memory, because a library does not report them.
#pragma once

#include <memory>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/peers/peer.hpp"

namespace edgewise::bench {

class PeerRunner final : public Runner {
  public:
    /// `info` must stay.
    explicit PeerRunner(const peers::PeerInfo& info);

    using Runner::answer;
    using Runner::trace;

    /// The distance and the witnesses: a library names no features, and no depth is asked for.
    [[nodiscard]] NamedAnswer answer(const scene::Query& query) const override;

    /// Whether the library is asked such a query: one too long or too short for its precision it never sees.
    [[nodiscard]] bool asks(const scene::Query& given) const { return in_range(prepared().prepared(given)); }

    /// Poses are in the library's own type before a query is asked. One such pass at a time: they share the
    /// pairs' caches.
    [[nodiscard]] RangePass prepared_range() const override;

    /// Traces nothing: the reads of a library cannot be observed from outside.
    PassSum trace(const TraceExtent& extent, measure::TraceListener& listener,
                  Distance* answers) const override;

    /// Allocations of a shape of the first body besides its object, all booked as vertex coordinates: a
    /// library does not report their purpose.
    [[nodiscard]] Ledger ledger() const override;
    [[nodiscard]] std::size_t object_bytes() const override { return bench_->object_bytes(); }
    [[nodiscard]] std::size_t pair_bytes() const override { return bench_->cache_bytes(); }
    [[nodiscard]] std::vector<TableMap> memory_maps() const override { return {}; }
    [[nodiscard]] BuildTimes build_times(int repetitions) const override;

  private:
    [[nodiscard]] Result<Polyhedron> store(const Polyhedron& body) const override;
    void build_tables(const std::vector<const Polyhedron*>& bodies) override;
    [[nodiscard]] std::size_t table_count() const override { return shapes_; }
    [[nodiscard]] double materialised() const override { return 1; }

    [[nodiscard]] peers::PeerQuery query_of(const scene::Query& query) const;

    const peers::PeerInfo& info_;
    std::unique_ptr<peers::PeerBench> bench_;
    std::size_t shapes_ = 0;
};

}  // namespace edgewise::bench
