// SPDX-License-Identifier: MIT
#include "edgewise/cli/stability_run.hpp"

#include <fmt/format.h>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/progress.hpp"
#include "edgewise/cli/stop.hpp"
#include "edgewise/sweep/shapes_of.hpp"

namespace edgewise::cli {

studies::StabilitySummary store_stability(const studies::StabilityPlan& plan, store::Store& store,
                                          std::size_t rows,
                                          const std::function<void(const studies::StabilityRow&)>& on_row) {
    const store::BuildRow build = bench::this_build();
    store.put_build(build);
    store.set_meta("build", build.id);
    Progress progress("stability", rows);
    return studies::run_stability(
        plan,
        [&](const studies::StabilityRow& row) {
            store.put_cell(build.id, row.cell, row.figures);
            if (on_row) {
                progress.clear();
                on_row(row);
            }
            progress.advance(1, row.cell.shape + " " + row.cell.table);
        },
        stop_on_signals());
}

std::vector<Polyhedron> real_bodies(const sweep::Plan& plan) {
    sweep::Plan meshes_only = plan;
    meshes_only.shapes.clear();
    std::vector<Polyhedron> bodies;
    const auto warn = [](const std::string& line) { fmt::print(stderr, "edgewise: {}\n", line); };
    if (meshes_only.meshes.empty()) return bodies;
    for (scene::NamedShape& shape : sweep::shapes_of(meshes_only, warn)) {
        if (shape.error.empty()) bodies.push_back(std::move(shape.body));
    }
    return bodies;
}

}  // namespace edgewise::cli
