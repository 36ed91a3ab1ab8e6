// SPDX-License-Identifier: MIT
//
// Without an earlier run a unit costs the seconds that progress expects for it. Costs decide only how even
// shards are.
#include "edgewise/studies/parts/sharded_work.hpp"

#include <algorithm>
#include <set>

#include "edgewise/input/count.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/store/merge.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/fields/fields_rows.hpp"
#include "edgewise/studies/paging_rows.hpp"
#include "edgewise/studies/parts/expected_seconds.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"
#include "edgewise/sweep/expected_work.hpp"

namespace edgewise::studies {

namespace {

double subjects_of(const std::vector<const bench::TableType*>& types,
                   const std::vector<std::string>& algorithms) {
    double subjects = 0;
    for (const bench::TableType* type : types)
        subjects += static_cast<double>(std::ranges::count_if(
            algorithms, [&](const std::string& algorithm) { return type->serves(algorithm); }));
    return subjects;
}

std::vector<std::string> families_of(const std::vector<std::string>& chosen) {
    if (!chosen.empty()) return chosen;
    std::vector<std::string> all;
    for (const scene::HardFamily& family : scene::hard_families()) all.push_back(family.name);
    return all;
}

/// Returns every unit of the work, in the order in which keep_shard takes them.
std::vector<sweep::ShardUnit> units_of(const sweep::SweepWork& work) {
    std::vector<sweep::ShardUnit> units;
    for (const sweep::SceneWork& scene : work.scenes) {
        for (const scene::NamedShape* shape : scene.shapes)
            units.push_back({sweep::comparison_name(scene, *shape),
                             estimated_work(work.plan, scene, *shape, count_cells(work, scene)).all()});
    }
    const double subjects = subjects_of(work.types, work.algorithms);
    if (work.plan.stability > 0) {
        const double seconds = static_cast<double>(work.plan.stability) * subjects * stability_case_seconds;
        for (const std::string& family : families_of(work.families))
            units.push_back({stability_unit(family), seconds});
    }
    if (work.plan.paging > 0)
        units.push_back({paging_unit, static_cast<double>(paging_rows()) * paging_row_seconds});
    if (work.plan.thrash)
        units.push_back({thrash_unit, static_cast<double>(thrash::thrash_units({})) * thrash_unit_seconds});
    if (work.plan.effort > 0)
        units.push_back(
            {effort_unit, static_cast<double>(work.plan.effort) * subjects * effort_query_seconds});
    if (work.plan.fields > 0)
        units.push_back(
            {fields_unit, static_cast<double>(fields_cells(work.plan.fields, work.plan.seed).size()) *
                              fields_cell_seconds});
    return units;
}

std::set<std::string> names_dealt(std::vector<sweep::ShardUnit> units, const sweep::Shard& shard,
                                  const std::map<std::string, double>& seconds) {
    sweep::weigh(units, seconds);
    std::set<std::string> names;
    for (const std::size_t unit : sweep::dealt_to(shard, units)) names.insert(units[unit].name);
    return names;
}

void keep_families(std::vector<std::string>& families, const std::set<std::string>& mine) {
    families = families_of(families);
    std::erase_if(families,
                  [&](const std::string& family) { return !mine.contains(stability_unit(family)); });
}

}  // namespace

std::string stability_unit(const std::string& family) { return "stability " + family; }

void keep_shard(sweep::SweepWork& work, const sweep::Shard& shard,
                const std::map<std::string, double>& seconds) {
    if (shard.is_whole()) return;
    const std::set<std::string> mine = names_dealt(units_of(work), shard, seconds);
    for (sweep::SceneWork& scene : work.scenes)
        std::erase_if(scene.shapes, [&](const scene::NamedShape* shape) {
            return !mine.contains(sweep::comparison_name(scene, *shape));
        });
    std::erase_if(work.scenes, [](const sweep::SceneWork& scene) { return scene.shapes.empty(); });
    keep_families(work.families, mine);
    if (work.families.empty()) work.plan.stability = 0;
    if (!mine.contains(paging_unit)) work.plan.paging = 0;
    if (!mine.contains(thrash_unit)) work.plan.thrash = false;
    if (!mine.contains(effort_unit)) work.plan.effort = 0;
    if (!mine.contains(fields_unit)) work.plan.fields = 0;
}

bool keep_shard(StabilityPlan& plan, const sweep::Shard& shard,
                const std::map<std::string, double>& seconds) {
    if (shard.is_whole()) return true;
    std::vector<sweep::ShardUnit> units;
    for (const std::string& family : families_of(plan.families)) units.push_back({stability_unit(family), 1});
    keep_families(plan.families, names_dealt(units, shard, seconds));
    return !plan.families.empty();
}

std::map<std::string, double> seconds_in(const std::string& store) {
    const std::string key_start = store::took_key;
    std::map<std::string, double> seconds;
    for (const auto& [key, value] : store::MergeSource(store).meta) {
        const auto number = key.starts_with(key_start) ? input::parse_number(value) : Result<double>{};
        if (number && *number >= 0) seconds[key.substr(key_start.size())] = *number;
    }
    return seconds;
}

}  // namespace edgewise::studies
