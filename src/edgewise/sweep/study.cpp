// SPDX-License-Identifier: MIT
#include "edgewise/sweep/study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/expected_work.hpp"

namespace edgewise::sweep {

namespace {

/// Returns the names of a study's parts; one without a name if it has none.
std::vector<std::string> parts_of(const Study& study) {
    return study.parts ? study.parts() : std::vector<std::string>{""};
}

/// Returns the units of the work. Without an earlier run a unit costs the seconds that progress expects.
std::vector<ShardUnit> units_of(const SweepWork& work) {
    std::vector<ShardUnit> units;
    for (const SceneWork& scene : work.scenes) {
        for (const scene::NamedShape* shape : scene.shapes)
            units.push_back({comparison_name(scene, *shape),
                             estimated_work(work.plan, scene, *shape, count_cells(work, scene)).all()});
    }
    for (const Study& study : registered_studies()) {
        if (!has_rows(study, work)) continue;
        const double seconds = static_cast<double>(study.rows(work)) * study.seconds_each(work);
        const std::vector<std::string> parts = parts_of(study);
        for (const std::string& part : parts)
            units.push_back({unit_name(study.name, part), seconds / static_cast<double>(parts.size())});
    }
    return units;
}

}  // namespace

std::string unit_name(std::string_view study, const std::string& part) {
    return std::string(study) + (part.empty() ? "" : " " + part);
}

bool has_rows(const Study& study, const SweepWork& work) {
    return work.plan.count_of(study.name) > 0 && study.rows(work) > 0;
}

void keep_shard(SweepWork& work, const Shard& shard, const std::map<std::string, double>& seconds) {
    if (shard.is_whole()) return;
    const std::set<std::string> mine = names_dealt_to(shard, units_of(work), seconds);
    for (SceneWork& scene : work.scenes)
        std::erase_if(scene.shapes, [&](const scene::NamedShape* shape) {
            return !mine.contains(comparison_name(scene, *shape));
        });
    std::erase_if(work.scenes, [](const SceneWork& scene) { return scene.shapes.empty(); });
    for (const Study& study : registered_studies()) {
        const std::vector<std::string> parts = parts_of(study);
        const auto is_mine = [&](const std::string& part) {
            return mine.contains(unit_name(study.name, part));
        };
        if (std::ranges::none_of(parts, is_mine)) work.plan.studies.erase(std::string(study.name));
        for (const std::string& part : parts)
            if (!is_mine(part)) work.parts_elsewhere.insert(unit_name(study.name, part));
    }
}

void store_chapter(const Study& study, store::Store& store) {
    if (study.chapter.title.empty()) return;
    nlohmann::json columns = nlohmann::json::array();
    for (const auto& [figure, title, unit] : study.chapter.columns)
        columns.push_back({{"figure", figure}, {"title", title}, {"unit", unit}});
    const nlohmann::json chapter = {
        {"title", study.chapter.title}, {"text", study.chapter.text}, {"columns", columns}};
    store.set_meta(store::study_key + std::string(study.name), chapter.dump());
}

}  // namespace edgewise::sweep
