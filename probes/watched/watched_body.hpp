// SPDX-License-Identifier: MIT
//
// A body as a support table that counts how GJK climbs on it. The answers are those of any table that holds
// the body in double.
#pragma once

#include <cstdint>

#include "edgewise/geometry/strictly_convex.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::probes {

/// Calls that sought a support point, rounds of their climbs, vertices they looked at.
struct ClimbCounts {
    std::uint64_t supports = 0, rounds = 0, vertices = 0;
};

class WatchedBody {
  public:
    using PrecisionType = f64;
    using Vertex = Index;

    WatchedBody(const Polyhedron& body, ClimbCounts& counts)
        : table_(body),
          strictly_convex_(is_strictly_convex(body, Tolerance<double>::strict_turn)),
          counts_(&counts) {}

    [[nodiscard]] std::size_t vertex_count() const { return table_.vertex_count(); }
    /// A climb or scan begins by asking it (algorithms/support.hpp), and nothing else does.
    [[nodiscard]] bool strictly_convex() const {
        ++counts_->supports;
        return strictly_convex_;
    }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Vec3d vertex(Vertex v) const {
        ++counts_->vertices;
        return table_.vertex(v);
    }
    [[nodiscard]] auto all_vertices() const { return table_.all_vertices(); }
    [[nodiscard]] auto neighbours(Vertex v) const {
        ++counts_->rounds;
        return table_.neighbours(v);
    }

    [[nodiscard]] bool are_neighbours(Vertex v, Vertex w) const {
        for (const Vertex next : table_.neighbours(v)) {
            if (next == w) return true;
        }
        return false;
    }

  private:
    Canonical table_;
    bool strictly_convex_;
    ClimbCounts* counts_;
};

static_assert(ClimbingTable<WatchedBody>);

}  // namespace edgewise::probes
