// SPDX-License-Identifier: MIT
//
// Times of building a table, and of refitting one in place, alternating: neighbours in time share the
// machine's moods. In memory that nobody used before, where the allocator has that.
#pragma once

#include "edgewise/layout_parts/write_geometry.hpp"
#include "edgewise/measure/memory_use.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::bench {

/// Of a body that the table can store; deformed, it is twice as large and back, with the topology kept.
template <class Table>
[[nodiscard]] measure::BuildTimes time_builds(const Polyhedron& body, Parts parts, int repetitions) {
    const Polyhedron larger = scene::scaled(body, 2);
    Table refitted(body, parts);
    measure::BuildTimes times;
    for (int i = 0; i < repetitions; ++i) {
        const measure::Stopwatch build_watch;
        const Table fresh(body, parts);
        times.build_ns.push_back(build_watch.elapsed_ns());
        if constexpr (Refittable<Table>) {
            const measure::Stopwatch refit_watch;
            refit(refitted, i % 2 == 0 ? larger : body);
            times.refit_ns.push_back(refit_watch.elapsed_ns());
        }
    }
    return times;
}

}  // namespace edgewise::bench
