// SPDX-License-Identifier: MIT
//
// The model: its constants are estimates of what parts of a group take beside each other, fitted to no
// measurement. A machine that is faster or slower in all of them changes no ratio, and the seconds of groups
// that the store remembers take the place of the model's.
#include "edgewise/sweep/expected_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edgewise/bench/cell.hpp"

namespace edgewise::sweep {

namespace {

/// s per query of a warm pair, and of a cold one, which walks across the body.
double query_seconds(const SceneWork& scene, double vertices) {
    const bool cold = (scene.kind.empty() ? scene.choice.name : scene.kind) == "cold";
    return (cold ? 150 + 90 * std::sqrt(vertices) : 100 + 20 * std::sqrt(vertices)) * 1e-9;
}

constexpr double exact_seconds = 3.2e-6;  ///< per vertex of a pair's body and checked query
constexpr int storages = 4;  ///< bodies differ by how they are stored: given, f32, f64, quantised
constexpr double table_seconds = 0.25e-6;  ///< per vertex of a table that is built
constexpr double traced_over_timed = 60;   ///< a traced query with its lines and reuse distances
constexpr double cached_over_timed = 60;   ///< and in the caches of each machine
constexpr double counted_passes = 6;       ///< groups of counters, and what is measured alone

double parameter(const SceneWork& scene, const char* name, double standard) {
    const auto found = scene.choice.parameters.find(name);
    return found == scene.choice.parameters.end() ? standard : found->second;
}

/// Tables that a cell builds.
double tables_of(const SceneWork& scene) {
    const std::string& kind = scene.kind.empty() ? scene.choice.name : scene.kind;
    const bool own = kind == "pressure" || parameter(scene, "own_tables", 0) > 0;
    return own ? parameter(scene, "bodies", 1) : 1;
}

}  // namespace

GroupWork modelled_work(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                        std::size_t cells) {
    if (!shape.error.empty()) return {};
    const auto count = static_cast<double>(cells), queries = static_cast<double>(scene.queries);
    const auto vertices = static_cast<double>(shape.body.vertex_count());
    const double each = query_seconds(scene, vertices);
    const double traced = plan.traced > 0 ? std::min(queries, static_cast<double>(plan.traced)) : queries;
    GroupWork work;
    work.verify = count * (queries * each + tables_of(scene) * vertices * table_seconds) +
                  storages * static_cast<double>(plan.checked) * vertices * exact_seconds;
    work.beside = count * queries * each * traced_over_timed;
    if (scene.models_caches(shape))
        work.beside += count * traced * each * cached_over_timed * static_cast<double>(plan.machines.size());
    work.rounds = (count + 1) * plan.rounds * queries * each;
    work.alone = count * queries * each * counted_passes;
    return work;
}

std::string group_key(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                      std::size_t cells) {
    return fmt::format("{} {} {} {} queries {} rounds {} cells{}", scene.choice.name,
                       bench::parameters_json(scene.choice.parameters), shape.name, scene.queries,
                       plan.rounds, cells, scene.models_caches(shape) ? " caches" : "");
}

std::vector<GroupWork> expected_work(
    const SweepWork& work, const std::function<std::optional<double>(const std::string& key)>& remembered) {
    std::vector<GroupWork> groups;
    std::vector<std::optional<double>> seconds;
    double known = 0, modelled = 0;  // of the groups that are remembered
    for (const SceneWork& scene : work.scenes) {
        std::size_t cells = 0;
        work.each_cell(scene, [&](const auto&, const auto&, const auto&) { ++cells; });
        for (const scene::NamedShape* shape : scene.shapes) {
            groups.push_back(modelled_work(work.plan, scene, *shape, cells));
            seconds.push_back(remembered(group_key(work.plan, scene, *shape, cells)));
            if (!seconds.back()) continue;
            known += *seconds.back();
            modelled += groups.back().all();
        }
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const double missed = known > 0 && modelled > 0 ? known / modelled : 1;
        GroupWork& group = groups[i];
        if (group.all() == 0) continue;  // of a body that there is not
        const double factor = seconds[i] ? *seconds[i] / group.all() : missed;
        group = {group.verify * factor, group.beside * factor, group.rounds * factor, group.alone * factor};
    }
    return groups;
}

}  // namespace edgewise::sweep
