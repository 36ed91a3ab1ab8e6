// SPDX-License-Identifier: MIT
//
// Data that a question for nearness needs of a workload's bodies besides their tables: the margin of each
// pair, and the reach of each body.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "edgewise/algorithms/distance_bounds.hpp"
#include "edgewise/bench/length_scale.hpp"
#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

class NearMargins {
  public:
    NearMargins() = default;

    /// `part`: the margin over the larger body's extent. The extents are the given bodies', so that every
    /// table is asked the same; the radii are those of the bodies as stored, which are in the unit.
    NearMargins(double part, bool asks_distance, std::span<const Polyhedron> given,
                std::span<const Polyhedron> stored, const LengthScale& scale)
        : asks_distance_(asks_distance) {
        for (const Polyhedron& body : given) margins_.push_back(part * extent(scale.into(body).vertices));
        for (const Polyhedron& body : stored) radii_.push_back(radius_of(body.vertices));
    }

    /// Margin of a query, in the unit.
    [[nodiscard]] double margin(const scene::Query& query) const {
        return std::max(margins_[query.body_a], margins_[query.body_b]);
    }
    [[nodiscard]] Radii radii(const scene::Query& query) const {
        return {radii_[query.body_a], radii_[query.body_b]};
    }

    [[nodiscard]] bool asks_distance() const { return asks_distance_; }
    /// The verdict of a warm pair's bounds; nothing where they do not decide, or the distance is asked too.
    [[nodiscard]] std::optional<bool> told_by(const DistanceBounds& bounds, const scene::Query& query,
                                              const Transform<double>& a_from_b) const {
        const std::optional<bool> told = bounds.nearer_than(margin(query), a_from_b);
        return told && *told && asks_distance_ ? std::nullopt : told;
    }

  private:
    bool asks_distance_ = false;           ///< of bodies that are nearer
    std::vector<double> margins_, radii_;  ///< of every body; empty where nothing asks for nearness
};

}  // namespace edgewise::bench
