// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/parts/sharded_work.hpp"

namespace edgewise::cli {

studies::StabilitySummary store_stability(const studies::StabilityPlan& plan, store::Store& store,
                                          const std::function<void(const studies::StabilityRow&)>& on_row) {
    const store::BuildRow build = bench::this_build();
    store.put_build(build);
    store.set_meta("build", build.id);
    store.set_meta("seed", std::to_string(plan.seed));
    std::map<std::string, double> seconds;
    measure::Stopwatch watch;
    const studies::StabilitySummary summary = studies::run_stability(
        plan,
        [&](const studies::StabilityRow& row) {
            store.put_cell(build.id, row.cell, row.figures);
            seconds[row.cell.shape] += watch.elapsed_ns() * 1e-9;
            watch.restart();
            on_row(row);
        },
        stop_on_signals());
    for (const auto& [family, took] : seconds) {
        if (!summary.stopped && took > 0.01)  // else it was there
            store.set_meta(store::took_key + studies::stability_unit(family), fmt::format("{:.3f}", took));
    }
    return summary;
}

}  // namespace edgewise::cli
