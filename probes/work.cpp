// SPDX-License-Identifier: MIT
#include "edgewise/probes/work.hpp"

#include <algorithm>
#include <bit>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/geometry/strictly_convex.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::probes {

namespace {

/// Calls that sought a support point, rounds of their climbs, vertices they looked at.
struct ClimbCounts {
    std::uint64_t supports = 0, rounds = 0, vertices = 0;
};

/// A body as a support table that counts how GJK climbs on it. The answers are those of any table that holds
/// the body in double.
class WatchedBody {
  public:
    using PrecisionType = f64;
    using Vertex = Index;

    WatchedBody(const Polyhedron& body, ClimbCounts& counts)
        : table_(body), climbable_(is_climbable(body)), counts_(&counts) {}

    [[nodiscard]] std::size_t vertex_count() const { return table_.vertex_count(); }
    [[nodiscard]] bool strictly_convex() const { return climbable_; }
    /// A climb or scan begins by asking it (algorithms/support.hpp), and nothing else does.
    [[nodiscard]] bool climbable() const {
        ++counts_->supports;
        return climbable_;
    }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Vec3d vertex(Vertex v) const {
        ++counts_->vertices;
        return table_.vertex(v);
    }
    [[nodiscard]] auto all_vertices() const { return table_.all_vertices(); }
    [[nodiscard]] auto neighbours(Vertex v) const {
        ++counts_->rounds;
        return table_.neighbours(v);
    }

    [[nodiscard]] bool are_neighbours(Vertex v, Vertex w) const {
        for (const Vertex next : table_.neighbours(v)) {
            if (next == w) return true;
        }
        return false;
    }

  private:
    Canonical table_;
    bool climbable_;
    ClimbCounts* counts_;
};

static_assert(ClimbingTable<WatchedBody>);

using Pair = SimplexPair<WatchedBody, WatchedBody>;

constexpr std::size_t most_queries = 10000;  ///< looked at; a share of them is known to a hundredth
constexpr std::size_t most_compared = 500;   ///< compared with V-Clip's features, each from a cold start

/// Is notified which subset every sub-distance accepted, and so how many were tried before it.
class SubsetWatch {
  public:
    SubsetWatch(AlgorithmWork& work, std::uint32_t cached)
        : work_(work), points_(std::max(1, static_cast<int>(cached))), is_first_(true) {}

    static void search() {}
    void iterate(PointMask members) {
        ++work_.sub_distances;
        ++work_.accepted[static_cast<std::size_t>(std::popcount(members)) - 1];
        // A cached tetrahedron is first asked whether it still holds the origin.
        const bool at_once = is_first_ && points_ == 4 && members == 15;
        work_.subsets_tried += at_once ? 1 : tried_until(members);
        points_ = std::min(4, std::popcount(members) + 1);
        is_first_ = false;
    }

  private:
    /// How far Johnson's search goes, which asks the whole last.
    [[nodiscard]] std::uint64_t tried_until(PointMask members) const {
        std::uint64_t tried = 0;
        for (const PointMask mask : ascending_subsets) {
            tried += mask >> points_ == 0;
            if (mask == members) return tried;
        }
        return tried + 1;
    }

    AlgorithmWork& work_;
    int points_;
    bool is_first_;
};

/// Counts the simplex's vertices on one body that were in the last simplex, or are neighbours of one there.
void compare_vertices(const WatchedBody& body, std::span<const Index> now, std::span<const Index> before,
                      AlgorithmWork& work) {
    for (const Index v : now) {
        const bool kept = std::find(before.begin(), before.end(), v) != before.end();
        const bool near = kept || std::any_of(before.begin(), before.end(),
                                              [&](Index old) { return body.are_neighbours(old, v); });
        ++work.kept_of;
        work.kept += kept;
        work.near += near;
    }
}

class GjkWatch {
  public:
    GjkWatch(const scene::Workload& workload, AlgorithmWork& work) : workload_(workload), work_(work) {
        for (const Polyhedron& body : workload.bodies) bodies_.emplace_back(body, counts_);
        for (std::uint32_t i = 0; i < workload.pair_count; ++i) pairs_.emplace_back();
    }

    void watch(const scene::Query& query) {
        const WatchedBody &a = bodies_[query.body_a], &b = bodies_[query.body_b];
        Pair cold;
        Pair& pair = workload_.warm ? pairs_[query.pair] : cold;
        const Pair before = pair;
        const ClimbCounts counts_before = counts_;
        SubsetWatch subsets(work_, before.count());
        static_cast<void>(Gjk::query(a, b, relative_pose(query.pose_a, query.pose_b), pair,
                                     {.sub_distance = SubDistanceSolver::johnson}, subsets));
        ++work_.queries;
        book_climbs(counts_before, std::max(1U, before.count()));
        if (before.count() == 0) return;
        const auto now_a = pair.vertices_a(), before_a = before.vertices_a();
        const auto now_b = pair.vertices_b(), before_b = before.vertices_b();
        compare_vertices(a, std::span(now_a).first(pair.count()), std::span(before_a).first(before.count()),
                         work_);
        compare_vertices(b, std::span(now_b).first(pair.count()), std::span(before_b).first(before.count()),
                         work_);
    }

  private:
    /// Books climbs. Visits to vertices of the cached simplex belong to no climb; each climb ends with a
    /// round that finds nothing higher.
    void book_climbs(const ClimbCounts& before, std::uint32_t cached) {
        const std::uint64_t rounds = counts_.rounds - before.rounds;
        const std::uint64_t supports = counts_.supports - before.supports;
        if (rounds < supports) return;  // scanned, not climbed
        work_.supports += supports;
        work_.hops += rounds - supports;
        work_.vertices += counts_.vertices - before.vertices - 2 * std::uint64_t{cached};
    }

    const scene::Workload& workload_;
    AlgorithmWork& work_;
    ClimbCounts counts_;
    std::vector<WatchedBody> bodies_;
    std::vector<Pair> pairs_;
};

/// Returns true if two of a face's vertices, in ring order, are ends of one of its edges.
bool side_by_side(const NamedFeature& face, Index v, Index w) {
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
        const Index tail = face.vertices[i], head = face.vertices[(i + 1) % face.vertices.size()];
        if ((tail == v && head == w) || (tail == w && head == v)) return true;
    }
    return false;
}

/// Returns true if a feature is the smallest that holds a simplex: on a face of more than three vertices the
/// simplex is three of them, or a diagonal.
bool rests_on(const NamedFeature& simplex, const NamedFeature& feature) {
    const auto& all = feature.vertices;
    const auto holds = [&](Index v) { return std::find(all.begin(), all.end(), v) != all.end(); };
    if (!std::all_of(simplex.vertices.begin(), simplex.vertices.end(), holds)) return false;
    if (feature.kind != FeatureKind::face) return simplex.vertices.size() == all.size();
    return simplex.vertices.size() > 2 ||
           (simplex.vertices.size() == 2 && !side_by_side(feature, simplex.vertices[0], simplex.vertices[1]));
}

/// Counts checked, separated queries where GJK's simplex rests on the features that V-Clip ends on.
void compare_features(const bench::TableType& type, const scene::Workload& workload,
                      std::span<const std::size_t> positions, AlgorithmWork& work) {
    const auto gjk = type.make_runner("gjk"), vclip = type.make_runner("vclip");
    if (!gjk->load(workload.bodies).empty() || !vclip->load(workload.bodies).empty()) return;
    for (const std::size_t i : positions) {
        if (work.compared == most_compared) return;
        const bench::NamedAnswer by_gjk = gjk->answer(workload.queries[i]);
        if (by_gjk.distance.status != Status::separated) continue;
        const bench::NamedAnswer by_vclip = vclip->answer(workload.queries[i]);
        ++work.compared;
        work.same_features +=
            rests_on(by_gjk.feature_a, by_vclip.feature_a) && rests_on(by_gjk.feature_b, by_vclip.feature_b);
    }
}

}  // namespace

AlgorithmWork gjk_work(const bench::TableType& type, const scene::Workload& workload,
                       std::span<const std::size_t> checked_positions) {
    AlgorithmWork work;
    GjkWatch watch(workload, work);
    for (std::size_t i = 0; i < std::min(most_queries, workload.queries.size()); ++i)
        watch.watch(workload.queries[i]);
    compare_features(type, workload, checked_positions, work);
    return work;
}

}  // namespace edgewise::probes
