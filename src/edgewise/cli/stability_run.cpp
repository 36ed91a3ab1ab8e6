// SPDX-License-Identifier: MIT
#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"

namespace edgewise::cli {

studies::StabilitySummary store_stability(const studies::StabilityPlan& plan, store::Store& store,
                                          const std::function<void(const studies::StabilityRow&)>& on_row) {
    const store::BuildRow build = bench::this_build();
    store.put_build(build);
    store.set_meta("build", build.id);
    return studies::run_stability(
        plan,
        [&](const studies::StabilityRow& row) {
            store.put_cell(build.id, row.cell, row.figures);
            on_row(row);
        },
        stop_on_signals());
}

}  // namespace edgewise::cli
