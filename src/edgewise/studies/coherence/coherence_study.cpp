// SPDX-License-Identifier: MIT
//
// How coherent the motion of a plan's scenes is, a row for each scene on each shape: recorded motion next
// to invented motion, in the same units. Turn and way are those of a pair's second body in the frame of its
// first, from one query of the pair to the next; sizes are extents of the smaller body.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/prepared_workload.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/sweep/study.hpp"
#include "edgewise/sweep/work.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::studies {

namespace {

constexpr const char* coherence_run = "coherence";
constexpr double near_contact = 0.01, touching = 1e-4;  ///< sizes

constexpr const char *has_no_steps = "not asked step by step", *has_no_motion = "no pair is asked twice";

class Motion {
  public:
    Motion(const scene::Workload& workload, std::size_t asked) : workload_(workload) {
        for (const Polyhedron& body : workload.bodies) {
            sizes_.push_back(extent(body.vertices));
            centres_.push_back(scene::vertex_mean(body.vertices));
        }
        follow_pairs();
        ask(std::min(asked, workload.queries.size()));
    }

    [[nodiscard]] std::vector<store::FigureRow> figures() const {
        std::vector<store::FigureRow> rows;
        const auto add = [&](const std::string& name, std::optional<double> value, const char* unit,
                             const char* reason) {
            rows.push_back({{name, value, unit, value ? "" : reason}, coherence_run});
        };
        constexpr std::pair<const char*, double> parts[] = {{"median", 0.5}, {"p90", 0.9}, {"p99", 0.99}};
        for (const auto& [name, part] : parts) {
            add(fmt::format("turn_{}", name), measure::quantile(turns_, part), "rad", has_no_motion);
            add(fmt::format("way_{}", name), measure::quantile(ways_, part), "sizes", has_no_motion);
        }
        const auto ratio = [](double a, double b) { return b > 0 ? std::optional(a / b) : std::nullopt; };
        const double queries = static_cast<double>(workload_.queries.size());
        add("pairs_per_step", ratio(queries, static_cast<double>(workload_.frames.size())), "1",
            has_no_steps);
        add("persistent", ratio(persist_, could_persist_), "1", has_no_motion);
        add("overlapping", overlapping_ / asked_, "1", "");
        add("near", near_ / asked_, "1", "");
        add("very_near", very_near_ / asked_, "1", "");
        return rows;
    }

  private:
    /// Motion of every pair from its last query; and how many pairs were there a step before.
    void follow_pairs() {
        const auto cold = bench::cold_starts(workload_);
        std::vector<const scene::Query*> last(workload_.pair_count, nullptr);
        std::size_t frame = 0;
        for (std::size_t i = 0; i < cold.size() && workload_.warm; ++i) {
            const scene::Query& query = workload_.queries[i];
            while (frame + 1 < workload_.frames.size() && workload_.frames[frame + 1].first_query <= i)
                ++frame;
            const bool has_past = workload_.frames.empty() || !workload_.frames[frame].starts_anew;
            could_persist_ += has_past;
            persist_ += has_past && !cold[i];
            if (!cold[i]) add_motion(*last[query.pair], query);
            last[query.pair] = &query;
        }
    }

    void add_motion(const scene::Query& before, const scene::Query& now) {
        const auto a = relative_pose(before.pose_a, before.pose_b), b = relative_pose(now.pose_a, now.pose_b);
        const Mat3d turn = a.rotation.transpose() * b.rotation;
        const Vec3d axis(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
        turns_.push_back(std::atan2(norm(axis), turn.trace() - 1));
        const Vec3d& centre = centres_[now.body_b];
        if (const double size = size_of(now); size > 0)  // none between two points
            ways_.push_back(norm(Vec3d(b.point(centre) - a.point(centre))) / size);
    }

    void ask(std::size_t count) {
        asked_ = static_cast<double>(count);
        for (std::size_t k = 0; k < count; ++k) {
            const scene::Query& query = workload_.queries[k * workload_.queries.size() / count];
            const Polyhedron &a = workload_.bodies[query.body_a], &b = workload_.bodies[query.body_b];
            SimplexPair<Canonical, Canonical> pair;
            const Distance answer =
                Gjk::query(Canonical(a), Canonical(b), relative_pose(query.pose_a, query.pose_b), pair);
            const bool apart = answer.status == Status::separated;
            overlapping_ += !apart;
            near_ += apart && answer.distance < near_contact * size_of(query);
            very_near_ += apart && answer.distance < touching * size_of(query);
        }
    }

    [[nodiscard]] double size_of(const scene::Query& query) const {
        const double size = std::min(sizes_[query.body_a], sizes_[query.body_b]);
        return size > 0 ? size : std::max(sizes_[query.body_a], sizes_[query.body_b]);  // one is a point
    }

    const scene::Workload& workload_;
    std::vector<double> sizes_, turns_, ways_;
    std::vector<Vec3d> centres_;
    double asked_ = 0, overlapping_ = 0, near_ = 0, very_near_ = 0, could_persist_ = 0, persist_ = 0;
};

store::CellRow coherence_row(const sweep::SweepWork& work, const sweep::SceneWork& scene,
                             const scene::NamedShape& shape) {
    store::CellRow row = sweep::row_of(work.plan, scene, shape);
    row.run = coherence_run;
    row.algorithm = row.table = "any";
    row.status = shape.error.empty() ? store::CellStatus::verified : store::CellStatus::unavailable;
    bench::name_cell(row, shape.body);
    return row;
}

bool run_coherence(const sweep::SweepWork& work, store::Store& store, const sweep::OnStudyRow& on_row,
                   const std::atomic<bool>& stop) {
    const std::string build = bench::this_build().id;
    for (const sweep::SceneWork& scene : work.scenes) {
        for (const scene::NamedShape* shape : scene.shapes) {
            if (stop) return false;
            const store::CellRow row = coherence_row(work, scene, *shape);
            if (row.verified() && !store.find_cell(build, row.hash)) {
                const sweep::SharedQueries shared = sweep::queries_of(work.plan, scene, *shape);
                store.put_cell(build, row,
                               Motion(shared.workload(), work.plan.count_of(coherence_run)).figures());
            }
            on_row(row.scene + " " + row.shape, row.status);
        }
    }
    return true;
}

std::size_t row_count(const sweep::SweepWork& work) {
    std::size_t rows = 0;
    for (const sweep::SceneWork& scene : work.scenes) rows += scene.shapes.size();
    return rows;
}

}  // namespace

sweep::Study coherence_study() {
    return {
        .name = coherence_run,
        .counts = input::queries_or_none,
        .rows = row_count,
        .seconds_each = [](const sweep::SweepWork&) { return 1.0; },
        .run = run_coherence,
        .chapter = {
            .title = "How coherent is the motion?",
            .text =
                "Recorded scenes next to invented ones. Turn and way: of a pair's second body in the frame "
                "of its first, from query to query, in radians and in sizes (extents of the smaller body). "
                "Persistent: pairs that were asked in the step before. Near: separated by less than 0.01 "
                "sizes; very near: by less than 0.0001. Of rounded bodies the cores are asked, without "
                "their radii. An invented scene answers for a recorded one as far as their rows agree.",
            .columns = {{"coherence.turn_median", "turn, median (1e-3 rad)", 1e-3},
                        {"coherence.turn_p90", "p90", 1e-3},
                        {"coherence.turn_p99", "p99", 1e-3},
                        {"coherence.way_median", "way, median (1e-3 sizes)", 1e-3},
                        {"coherence.way_p90", "p90", 1e-3},
                        {"coherence.way_p99", "p99", 1e-3},
                        {"coherence.pairs_per_step", "pairs per step"},
                        {"coherence.persistent", "persistent (%)", 0.01},
                        {"coherence.overlapping", "overlapping (%)", 0.01},
                        {"coherence.near", "near (%)", 0.01},
                        {"coherence.very_near", "very near (%)", 0.01}}}};
}

}  // namespace edgewise::studies
