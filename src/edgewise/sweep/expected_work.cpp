// SPDX-License-Identifier: MIT
#include "edgewise/sweep/expected_work.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "edgewise/bench/cell.hpp"

namespace edgewise::sweep {

namespace {

/// How far off the speed of a kind is that has not run yet, as a logarithm: work is counted by rules of
/// thumb, while an earlier run measured.
const double unmeasured = std::log(2.5), remembered = std::log(1.4);

}  // namespace

void TimeLeft::Speeds::add(double work, double seconds) {
    if (!(work > 0 && seconds > 0)) return;
    const double log = std::log(seconds / work);
    weight += work;
    sum += work * log;
    squares += work * log * log;
    weight_squares += work * work;
}

double TimeLeft::Speeds::deviation(double at_first) const {
    if (!(weight > 0)) return at_first;
    const double mean = sum / weight, variance = std::max(0.0, squares / weight - mean * mean);
    const double groups = weight * weight / weight_squares;  // of equal weight
    return std::sqrt((groups * variance + at_first * at_first) / (groups + 1));
}

void TimeLeft::done(const std::string& kind, double work, double seconds) {
    Kind& one = kinds_[kind];
    one.ahead -= work;
    one.work += work;
    one.seconds += seconds;
    one.group_work += work;
    one.group_seconds += seconds;
}

void TimeLeft::end_group() {
    for (auto& [name, kind] : kinds_) {
        kind.groups.add(kind.group_work, kind.group_seconds);
        kind.group_work = kind.group_seconds = 0;
    }
}

std::optional<double> TimeLeft::seconds() const {
    double work = 0, took = 0;
    for (const auto& [name, kind] : kinds_) {
        work += kind.work;
        took += kind.seconds;
    }
    double left = 0, variance = 0;
    for (const auto& [name, kind] : kinds_) {
        if (!(kind.ahead > 0)) continue;
        const bool known = name == last_run;
        // A kind that has not run yet is as much slower or faster here as all others together.
        const double speed = kind.work > 0          ? kind.seconds / kind.work
                             : known || !(work > 0) ? 1
                                                    : took / work;
        Speeds speeds = kind.groups;
        speeds.add(kind.group_work, kind.group_seconds);
        const double rest = kind.ahead * speed, deviation = speeds.deviation(known ? remembered : unmeasured);
        left += rest;
        variance += rest * rest * deviation * deviation;
    }
    if (!(left > 0) || std::sqrt(variance) / left > std::log(largest_factor)) return std::nullopt;
    return left;
}

namespace {

constexpr double query_seconds = 75e-9;      ///< of a query, times the root of the vertices
constexpr double vertex_seconds = 0.3e-6;    ///< of a vertex of a table that is built
constexpr double exact_seconds = 12e-6;      ///< of a checked query, times the root of the vertices
constexpr double traced_factor = 300;        ///< a query with modelled caches, over a query
constexpr double followed_seconds = 1e-6;    ///< of a query with followed lines, per step of the search
constexpr double point_seconds = 1e-6;       ///< the same per vertex of a table of points
constexpr double followed_queries = 1000;    ///< at most
constexpr double counted_seconds = 1e-6;     ///< of a query in what else is counted cell by cell
constexpr double out_of_cache = 5;           ///< a query with tables in memory, over one in cache
constexpr double trace_out_of_cache = 2.5;   ///< the same with modelled caches
constexpr double cached_vertices = 100'000;  ///< of tables that together fit a cache
constexpr double pairs_per_body = 1.2;       ///< that the broad phase leaves in a step

double parameter(const SceneWork& scene, const char* name, double standard) {
    const auto found = scene.choice.parameters.find(name);
    return found == scene.choice.parameters.end() ? standard : found->second;
}

const std::string& kind_of(const SceneWork& scene) {
    return scene.kind.empty() ? scene.choice.name : scene.kind;
}

/// Tables that a cell builds.
double tables_of(const SceneWork& scene) {
    return parameter(scene, "own_tables", 0) > 0 ? parameter(scene, "bodies", 1) : 1;
}

/// Returns the time of a query with tables in cache. A search across the body meets about the root of its
/// vertices. The less a body turns in a step, the more a pair's last answer helps; most queries of `pressure`
/// are first ones.
double seconds_per_query(const SceneWork& scene, double vertices) {
    const bool searches = kind_of(scene) == "pressure" || parameter(scene, "random_orientation", 0) > 0;
    const double turn = searches ? 1 : std::clamp(parameter(scene, "rotation_step", 1), 0.05, 1.0);
    return query_seconds * (4 + std::sqrt(turn * vertices));
}

/// Returns the number of queries; scenes with a number of steps have those of their steps.
double queries_of(const SceneWork& scene) {
    const double stepped =
        parameter(scene, "least_steps", 0) * parameter(scene, "bodies", 0) * pairs_per_body;
    return std::max(static_cast<double>(scene.queries), stepped);
}

}  // namespace

std::string GroupWork::kind(Step step) const {
    constexpr const char* names[] = {"verify", "trace", "rounds", "alone"};
    if (remembered) return TimeLeft::last_run;
    return std::string(names[static_cast<std::size_t>(step)]) + (own_tables ? ", own tables" : "");
}

CellCount count_cells(const SweepWork& work, const SceneWork& scene) {
    CellCount cells;
    work.each_cell(scene, [&](const bench::TableType& type, const auto&, const auto&) {
        ++cells.all;
        cells.points += !type.is_peer && !type.serves("vclip");
    });
    return cells;
}

GroupWork estimated_work(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                         const CellCount& cells, unsigned processors) {
    if (!shape.error.empty()) return {};
    const auto count = static_cast<double>(cells.all), queries = queries_of(scene);
    const auto vertices = static_cast<double>(shape.body.vertex_count());
    const double tables = tables_of(scene), in_cache = seconds_per_query(scene, vertices);
    const bool fits = tables * vertices <= cached_vertices;
    const double query = fits ? in_cache : out_of_cache * in_cache;
    const auto checked = static_cast<double>(std::min(plan.checked, scene.queries));
    const double traced = plan.traced > 0 ? std::min(queries, static_cast<double>(plan.traced)) : queries;
    GroupWork work;
    work.own_tables = tables > 1;
    work.parts[0] = count * (queries * query + tables * vertices * vertex_seconds) +
                    checked * std::sqrt(vertices) * exact_seconds;
    if (scene.models_caches(shape))
        work.parts[1] = count * traced * static_cast<double>(plan.machines.size()) * traced_factor *
                        in_cache * (fits ? 1 : trace_out_of_cache) / std::max(1U, processors);
    work.parts[2] = (count + 1) * plan.rounds * queries * query;  // with the baseline
    const double followed = std::min(queries, followed_queries);
    work.parts[3] = count * (queries * (query + counted_seconds) +
                             followed * (10 + std::sqrt(vertices)) * followed_seconds) +
                    static_cast<double>(cells.points) * followed * vertices * point_seconds;
    return work;
}

std::string group_key(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                      std::size_t cells) {
    return fmt::format("{} {} {} {} queries {} rounds {} cells{}", scene.choice.name,
                       bench::parameters_json(scene.choice.parameters), shape.name, scene.queries,
                       plan.rounds, cells, scene.models_caches(shape) ? " caches" : "");
}

std::vector<GroupWork> expected_work(
    const SweepWork& work, const std::function<std::optional<double>(const std::string& key)>& took_before) {
    std::vector<GroupWork> groups;
    for (const SceneWork& scene : work.scenes) {
        const CellCount cells = count_cells(work, scene);
        for (const scene::NamedShape* shape : scene.shapes) {
            GroupWork& group = groups.emplace_back(estimated_work(work.plan, scene, *shape, cells));
            const auto took = took_before(group_key(work.plan, scene, *shape, cells.all));
            group.remembered = took && group.all() > 0;
            if (!group.remembered) continue;
            const double factor = *took / group.all();
            for (double& part : group.parts) part *= factor;
        }
    }
    return groups;
}

}  // namespace edgewise::sweep
