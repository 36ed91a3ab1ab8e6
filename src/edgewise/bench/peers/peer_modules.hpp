// SPDX-License-Identifier: MIT
//
// The peers of this program: modules in a folder next to it, opened when they are first needed. Each is a
// table type with one algorithm of its own name, and a runner: same bodies, same poses, same clock and same
// checks as a table type of Edgewise. It has no traces and no pieces of memory, because a library does not
// report them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/peers/peer.hpp"

namespace edgewise::bench {

/// Table types of the peers, by name and precision. Each serves one algorithm, of its layout's name. If a
/// module cannot be opened, throws std::runtime_error with its name and the reason.
[[nodiscard]] std::span<const TableType> peer_types();

/// Algorithms of the peers: one for each name among them.
[[nodiscard]] std::span<const AlgorithmInfo> peer_algorithms();

/// Names as a user writes them: "bullet_epa2", "bullet_epa2_f64", "all". Throws std::invalid_argument that
/// lists the known names; where there are none at all, what to do.
[[nodiscard]] std::vector<const TableType*> select_peer_types(std::span<const std::string> names);

/// Returns true if this query loop was also compiled as applications compile it: -O2, no flag for a
/// processor. Such modules are in the folder `default_builds` next to the program.
[[nodiscard]] bool has_default_build(const TableType& type, std::string_view algorithm);
/// A runner of that loop; it must have one.
[[nodiscard]] std::unique_ptr<Runner> make_default_build(const TableType& type, std::string_view algorithm);

/// Runs the queries of a workload by a peer.
class PeerRunner final : public Runner {
  public:
    /// `info` must outlive the runner.
    explicit PeerRunner(const peers::PeerInfo& info);

    using Runner::answer, Runner::trace;

    /// The distance and the witnesses: a library names no features, and no depth is asked for.
    [[nodiscard]] NamedAnswer answer(const scene::Query& query) const override;

    /// Returns true if the library is asked such a query: false for one that is too large or too small for
    /// its precision.
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
