// SPDX-License-Identifier: MIT
//
// Data that a question for nearness needs of a workload's bodies besides their tables: the margin of each
// pair, and the reach of each body.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

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
    NearMargins(double part, std::span<const Polyhedron> given, std::span<const Polyhedron> stored,
                const LengthScale& scale) {
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

  private:
    std::vector<double> margins_, radii_;  ///< of every body; empty where nothing asks for nearness
};

}  // namespace edgewise::bench
