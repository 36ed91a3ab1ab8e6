// SPDX-License-Identifier: MIT
//
// Memory cost of one table besides its own bytes: in each allocator, in pages, and in cache lines that
// queries touch. Measured on tables that are really built, each allocator's in turn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"

namespace edgewise::studies {

struct AllocatorCost {
    std::string allocator;
    std::optional<std::size_t> taken;          ///< bytes; nothing: see `reason`
    std::optional<std::size_t> by_statistics;  ///< by the allocator's own count, where it keeps one
    std::optional<std::size_t> resident;       ///< bytes of pages in memory, if known
    std::string reason;
};

/// Returns the costs of a table. The table stores the parts of a body in `parts`, if its layout can.
[[nodiscard]] std::vector<AllocatorCost> allocator_costs(const bench::TableType& type, const Polyhedron& body,
                                                         Parts parts);

/// Returns the lines that this algorithm's first warm queries read in the scene `tumble` at 0.1 rad per
/// step, with bodies of this shape. Fails if the scene does: for bodies without a volume.
[[nodiscard]] Result<measure::LinesTouched> lines_in_tumble(const bench::TableType& type,
                                                            const std::string& algorithm,
                                                            const Polyhedron& body);

/// Bytes of a whole table per additional edge, for bodies with rings of one index width in the narrowest
/// form.
struct WidthSlope {
    int offset_bits, neighbour_bits;
    std::size_t least_vertices, most_vertices;
    std::optional<double> bytes_per_edge;  ///< nothing if the bodies are too large for the layout
    std::string reason;                    ///< of a missing value
};

/// Returns slopes fitted over spheres of 8 to 100 000 vertices, range by range. Takes seconds per table type.
[[nodiscard]] std::vector<WidthSlope> slopes_by_width(const bench::TableType& type, Parts parts);

}  // namespace edgewise::studies
