// SPDX-License-Identifier: MIT
//
// The one place that talks to Qhull (Barber, Dobkin, Huhdanpaa 1996), through its reentrant C library.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

struct QhullFacets {
    std::vector<std::vector<Index>> rings;  ///< corners of each facet, all facets wound the same way
    std::string error;                      ///< Qhull's first line, when it gave up
};

/// Facets of the hull of `points`, as Qhull merges them by its own rounding bounds.
[[nodiscard]] QhullFacets qhull_facets(std::span<const Vec3d> points);

}  // namespace edgewise
