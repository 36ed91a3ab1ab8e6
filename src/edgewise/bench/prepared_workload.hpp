// SPDX-License-Identifier: MIT
//
// A workload as a runner's tables take it, made ready once: bodies as they are stored, in the runner's unit
// of length, and queries in that unit with rotations that are orthonormal.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/length_scale.hpp"
#include "edgewise/bench/runner_options.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Flags the queries of a warm scene that are the first of their pair: cold by nature, and left out of the
/// figures of warm queries. One flag per query; all zero where every query is cold.
[[nodiscard]] std::vector<std::uint8_t> cold_starts(const scene::Workload& workload);

/// A workload's queries, in an order in which those of one class follow each other as far as no pair comes
/// again, so that batches of one class are full. Every pair's queries stay in time order.
struct ClassByClass {
    scene::Workload workload;              ///< without bodies
    std::vector<std::uint8_t> in_contact;  ///< of its queries

    ClassByClass(const scene::Workload& given, std::span<const std::uint8_t> in_contact_as_given);
};

class PreparedWorkload {
  public:
    /// `store` gives the body that a table holds of one. An error line when a body cannot be stored.
    [[nodiscard]] std::string take_bodies(std::span<const Polyhedron> bodies, VertexOrder order,
                                          const std::function<Result<Polyhedron>(const Polyhedron&)>& store);

    /// Takes queries about these bodies. Unchanged data is not copied: `workload` must stay where it is.
    void take_queries(const scene::Workload& workload);

    [[nodiscard]] const LengthScale& scale() const { return scale_; }
    /// Stored bodies: in the unit, from which tables are built, and as given.
    [[nodiscard]] const std::vector<Polyhedron>& bodies() const { return bodies_; }
    [[nodiscard]] const std::vector<Polyhedron>& unscaled_bodies() const {
        return scale_.is_one() ? bodies_ : unscaled_;
    }
    /// The queries, in the unit. Its `bodies` are not for use.
    [[nodiscard]] const scene::Workload& workload() const { return given_ ? *given_ : copy_; }

    /// A query of the given bodies made ready.
    [[nodiscard]] scene::Query prepared(const scene::Query& given) const;

    /// Returns true if the offset between the bodies of a prepared query is in range: not too long, nor,
    /// between points at their origins, too short.
    [[nodiscard]] bool in_range(const scene::Query& query, bool in_single) const;

  private:
    LengthScale scale_;
    std::vector<Polyhedron> bodies_, unscaled_;  ///< the latter only where the scale is not one
    scene::Workload copy_;
    const scene::Workload* given_ = nullptr;  ///< where it needed no change
};

}  // namespace edgewise::bench
