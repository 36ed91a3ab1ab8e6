// SPDX-License-Identifier: MIT
//
// The stability run as a study: its parts are the hard families.
#include <map>

#include "edgewise/scene/hard/families.hpp"
#include "edgewise/studies/stability/stability.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::studies {

namespace {

std::vector<std::string> all_families() {
    std::vector<std::string> all;
    for (const scene::HardFamily& family : scene::hard_families()) all.push_back(family.name);
    return all;
}

StabilityPlan stability_plan(const sweep::SweepWork& work) {
    StabilityPlan plan;
    plan.families = all_families();
    std::erase_if(plan.families, [&](const std::string& family) {
        return work.parts_elsewhere.contains(sweep::unit_name(stability_run, family));
    });
    plan.count = plan.proofs = work.plan.count_of(stability_run);
    plan.seed = work.plan.seed;
    plan.raw = work.plan.control;
    plan.types = work.types;
    plan.algorithms = work.algorithms;
    for (const scene::NamedShape& shape : work.shapes) {
        if (shape.error.empty() && shape.source != "built-in") plan.real.push_back(shape.body);
    }
    return plan;
}

bool run_stability_study(const sweep::SweepWork& work, store::Store& store, const sweep::OnStudyRow& on_row,
                         const std::atomic<bool>& stop) {
    const auto notify = [&](const store::StoredCell& row) {
        on_row(row.shape + " " + row.table, row.status);
    };
    return run_stability(stability_plan(work), store, notify, stop);
}

}  // namespace

bool keep_shard(StabilityPlan& plan, const sweep::Shard& shard,
                const std::map<std::string, double>& seconds) {
    if (shard.is_whole()) return true;
    if (plan.families.empty()) plan.families = all_families();
    std::vector<sweep::ShardUnit> units;
    for (const std::string& family : plan.families)
        units.push_back({sweep::unit_name(stability_run, family), 1});
    const auto mine = names_dealt_to(shard, units, seconds);
    std::erase_if(plan.families, [&](const std::string& family) {
        return !mine.contains(sweep::unit_name(stability_run, family));
    });
    return !plan.families.empty();
}

sweep::Study stability_study() {
    return {.name = stability_run,
            .counts = input::cases_or_none,
            .rows = [](const sweep::SweepWork& work) { return stability_rows(stability_plan(work)); },
            .seconds_each =
                [](const sweep::SweepWork& work) {
                    constexpr double case_seconds = 0.0007;
                    return case_seconds * static_cast<double>(work.plan.count_of(stability_run));
                },
            .run = run_stability_study,
            .parts = all_families,
            .of_bodies = true};
}

}  // namespace edgewise::studies
