// SPDX-License-Identifier: MIT
//
// The model: its constants were fitted by hand to the seconds of plan quick on a machine of two cores, group
// by group (tests/unit/sweep/progress_model_test.cpp has them). A machine that is faster or slower in all of
// them changes no ratio, and the seconds of groups that the store remembers take the place of the model's.
#include "edgewise/sweep/expected_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edgewise/bench/cell.hpp"

namespace edgewise::sweep {

namespace {

// ns per query by the square root of the body's vertices, of which a walk across the body meets so many.
struct PerQuery {
    double least, per_root;

    [[nodiscard]] double seconds(double vertices) const {
        return (least + per_root * std::sqrt(vertices)) * 1e-9;
    }
};
constexpr PerQuery cold_query{300, 73};     ///< pairs that have not met before
constexpr PerQuery still_query{130, 3};     ///< pairs that hardly moved
constexpr PerQuery static_query{190, 152};  ///< of the scene static: half of its pairs overlap deeply

constexpr double out_of_cache = 4.5;           ///< times as long a query takes whose tables are in memory
constexpr double cached_vertices = 50'000;     ///< of tables of their own that together fit a cache
constexpr double table_seconds = 0.55e-6;      ///< per vertex of a table that is built
constexpr double exact_seconds = 0.4e-6;       ///< per vertex and checked query, of all storages of bodies
constexpr double cell_seconds = 0.003;         ///< what probes take whatever the queries are
constexpr double passes = 1.5;                 ///< of all queries, by probes that count
constexpr double followed_queries = 1000,      ///< about as many are traced for their lines, each
    followed_factor = 23.5;                    ///< so many times as long as a timed one
constexpr double cached_query_least = 114e-6,  ///< s per query and machine whose caches are modelled, and
    cached_query_factor = 40;                  ///< of a timed one in cache beside that
constexpr double fitted_processors = 2;        ///< that shared what is beside others

double parameter(const SceneWork& scene, const char* name, double standard) {
    const auto found = scene.choice.parameters.find(name);
    return found == scene.choice.parameters.end() ? standard : found->second;
}

const std::string& kind_of(const SceneWork& scene) {
    return scene.kind.empty() ? scene.choice.name : scene.kind;
}

/// Tables that a cell builds.
double tables_of(const SceneWork& scene) {
    const bool own = kind_of(scene) == "pressure" || parameter(scene, "own_tables", 0) > 0;
    return own ? parameter(scene, "bodies", 1) : 1;
}

/// s per query that finds its tables in a cache. The more a body turns in a step, the less a pair's last
/// answer helps: by the root of the angle, up to a rad.
double query_seconds(const SceneWork& scene, double vertices) {
    const double cold = cold_query.seconds(vertices), still = still_query.seconds(vertices);
    if (kind_of(scene) == "static") return static_query.seconds(vertices);
    // Every other query of the scene pressure is its pair's first.
    const bool turns = scene.choice.parameters.contains("rotation_step") && kind_of(scene) != "pressure";
    if (!turns) return cold;
    const double turn =
        parameter(scene, "random_orientation", 0) > 0 ? 1 : parameter(scene, "rotation_step", 0);
    return still + std::sqrt(std::min(1.0, turn)) * (cold - still);
}

}  // namespace

GroupWork modelled_work(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                        std::size_t cells, unsigned processors) {
    if (!shape.error.empty()) return {};
    const auto count = static_cast<double>(cells), queries = static_cast<double>(scene.queries);
    const auto vertices = static_cast<double>(shape.body.vertex_count());
    const double tables = tables_of(scene), in_cache = query_seconds(scene, vertices);
    const double each = tables * vertices > cached_vertices ? out_of_cache * in_cache : in_cache;
    const double traced = plan.traced > 0 ? std::min(queries, static_cast<double>(plan.traced)) : queries;
    GroupWork work;
    // With the baseline's.
    work.verify = count * queries * each + (count + 1) * tables * vertices * table_seconds +
                  static_cast<double>(plan.checked) * vertices * exact_seconds;
    if (scene.models_caches(shape))
        work.beside = count * traced * static_cast<double>(plan.machines.size()) *
                      (cached_query_least + cached_query_factor * in_cache) * fitted_processors /
                      std::max(1U, processors);
    work.rounds = (count + 1) * plan.rounds * queries * each;
    work.alone = count * (cell_seconds + in_cache * (passes * queries +
                                                     followed_factor * std::min(queries, followed_queries)));
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
