// SPDX-License-Identifier: MIT
#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/progress.hpp"

namespace edgewise::cli {

studies::StabilitySummary store_stability(const studies::StabilityPlan& plan, store::Store& store,
                                          const std::function<void(const studies::StabilityRow&)>& on_row) {
    const store::BuildRow build = bench::this_build();
    store.put_build(build);
    store.set_meta("build", build.id);
    Progress progress("stability", studies::stability_rows(plan));
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

}  // namespace edgewise::cli
