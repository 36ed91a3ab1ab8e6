// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/walk.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/bench/name_answer.hpp"
#include "edgewise/layout_parts/derived/derived_table.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::bench {

namespace {

/// Vertices of the canonical body, for a table that derives all features from its rings.
struct CanonicalPoints {
    const Polyhedron* body = nullptr;

    static void place(BlockPlan& /*plan*/, const BodyFacts& /*facts*/) {}
    static void write(std::byte* /*base*/, const Polyhedron& /*body*/) {}
    [[nodiscard]] const Vec3d& read(const Direct& /*loader*/, const std::byte* /*base*/, Index v) const {
        return body->vertices[v];
    }
};

using DerivedBody = DerivedTable<CanonicalPoints, f64, Direct>;

/// The body with planes of unit normals, as layouts store them: where rings are compared by distances,
/// another edge may be the most violated one, and V-Clip takes another way.
class StoredBody : public DerivedPlanes<CanonicalPoints, f64, Direct> {
    using Base = DerivedPlanes<CanonicalPoints, f64, Direct>;

  public:
    using RingName = Base::Edge;  ///< rings are walked by their edges
    using Base::Base;

    [[nodiscard]] AnchoredPlane<double> vertex_edge_plane(const Edge& e, End end) const {
        return with_unit_normal(Base::vertex_edge_plane(e, end));
    }
    [[nodiscard]] AnchoredPlane<double> edge_face_plane(const Edge& e, Side side) const {
        return with_unit_normal(Base::edge_face_plane(e, side));
    }

  private:
    [[nodiscard]] static AnchoredPlane<double> with_unit_normal(AnchoredPlane<double> plane) {
        if (const double length = norm(plane.normal); length > 0) plane.normal = plane.normal / length;
        return plane;
    }
};

/// Observes V-Clip: notes both features at each state.
template <class Table>
struct FeatureNotes {
    const vclip::Body<Table>&a, &b;
    Polyhedron names = {};  ///< calls vertices by their own numbers
    std::vector<WalkStep> steps = {};

    void visit(FeatureKind kind_a, FeatureKind kind_b) {
        steps.push_back({step_of(kind_a, kind_b), name_feature(a.table, names, a.feature).vertices,
                         name_feature(b.table, names, b.feature).vertices});
    }
    void ask_gjk() { steps.clear(); }
};

/// States of V-Clip from a cold start; empty if it passes the query to GJK.
template <class Table>
std::vector<WalkStep> vclip_walk(const Table& table_a, const Table& table_b,
                                 const Transform<double>& into_a) {
    const Transform<double> into_b = into_a.inverse();
    const auto start = Features<Table, Table>::first_of(table_a, table_b);
    vclip::Body<Table> a{table_a, into_a, start.a}, b{table_b, into_b, start.b};
    FeatureNotes<Table> notes{a, b};
    notes.names.input_index.resize(std::max(table_a.vertex_count(), table_b.vertex_count()));
    std::iota(notes.names.input_index.begin(), notes.names.input_index.end(), Index{0});
    FirstTry first = FirstTry::walk;
    static_cast<void>(vclip::answer_from(a, b, notes, true, first));
    return std::move(notes.steps);
}

/// The canonical body, which notes its support points.
class SupportBody : public Canonical {
  public:
    using Canonical::Canonical;

    [[nodiscard]] Vertex scan_support(const Vec3d& direction) const {
        last_ = scan_any(static_cast<const Canonical&>(*this), direction).vertex;
        return last_;
    }
    [[nodiscard]] Vertex last() const { return last_; }

  private:
    mutable Vertex last_ = 0;
};

/// Observes GJK: notes the simplex before each iteration, from the support points and from the members that
/// are kept. A search in singles is one step, and its simplex is known at its end.
struct SimplexNotes {
    const SupportBody &a, &b;
    std::vector<WalkStep> steps = {};
    std::vector<Index> on_a = {}, on_b = {};

    void search() { steps.push_back({TraceStep::gjk_iteration}); }
    void iterate(unsigned members) {
        on_a.push_back(a.last()), on_b.push_back(b.last());
        steps.push_back({TraceStep::gjk_iteration});
        WalkStep& step = steps.back();
        for (std::size_t i = 0; i < on_a.size(); ++i)
            if ((members >> i & 1) != 0) step.a.push_back(on_a[i]), step.b.push_back(on_b[i]);
        on_a = step.a, on_b = step.b;
    }
};

/// Iterations of GJK from a cold start; empty if it went back in its search.
std::vector<WalkStep> gjk_walk(const Polyhedron& body_a, const Polyhedron& body_b,
                               const Transform<double>& a_from_b) {
    const SupportBody a(body_a), b(body_b);
    SimplexPair<SupportBody, SupportBody> pair(a, b);
    SimplexNotes notes{a, b};
    static_cast<void>(Gjk::query(a, b, a_from_b, pair, {}, notes));
    std::vector<Index> end_a, end_b;
    for (std::uint32_t i = 0; i < pair.count(); ++i)
        end_a.push_back(pair.corner(i).a), end_b.push_back(pair.corner(i).b);
    if (notes.steps.empty()) return {};
    WalkStep& last = notes.steps.back();
    if (notes.steps.size() == 1 && last.a.empty()) last.a = end_a, last.b = end_b;
    if (last.a != end_a || last.b != end_b || notes.steps.front().a.empty()) return {};
    return std::move(notes.steps);
}

}  // namespace

WalkTrace::WalkTrace(std::string_view algorithm, std::span<const Polyhedron> stored,
                     const scene::Workload& workload, std::size_t within) {
    constexpr std::size_t most_tried = 200, least_steps = 4;
    const std::vector<std::uint8_t> first_of_pair = cold_starts(workload);
    std::vector<DerivedBody> derived;
    std::vector<StoredBody> with_planes;
    for (const Polyhedron& body : stored) {
        if (algorithm != VClip::name) break;
        derived.emplace_back(body, Parts::features, Direct{}, CanonicalPoints{&body});
        with_planes.emplace_back(body, Parts::features, Direct{}, CanonicalPoints{&body});
    }
    std::vector<Walk> walks;
    for (std::size_t i = 0; i < std::min(within, first_of_pair.size()) && walks.size() < most_tried; ++i) {
        if (workload.warm && !first_of_pair[i]) continue;
        const scene::Query& query = workload.queries[i];
        const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
        Walk& walk = walks.emplace_back();
        walk.query = i;
        walk.steps = derived.empty() ? gjk_walk(stored[query.body_a], stored[query.body_b], a_from_b)
                                     : vclip_walk(derived[query.body_a], derived[query.body_b], a_from_b);
        if (!derived.empty() &&
            walk.steps != vclip_walk(with_planes[query.body_a], with_planes[query.body_b], a_from_b))
            walk.steps.clear();
    }
    if (walks.empty()) return;
    const auto length = [](const Walk& walk) { return walk.steps.size(); };
    std::ranges::stable_sort(walks, {}, length);
    const auto first_long = std::ranges::lower_bound(walks, least_steps, {}, length);
    walk_ = first_long == walks.end() ? walks.back() : first_long[(walks.end() - first_long) / 2];
}

void WalkTrace::on_step_start(std::uint8_t step) {
    if (follows_) traced_.push_back({static_cast<TraceStep>(step)});
}

void WalkTrace::on_access(const measure::TracedAccess& access) {
    if (!follows_ || access.side == measure::TraceSide::scene) return;
    access.for_each_unit(measure::cache_line, [&](std::uint64_t line) { traced_.back().lines.insert(line); });
}

std::optional<Walk> WalkTrace::walk(std::span<const TableMap> maps) const {
    Walk walk = walk_;
    walk.steps.insert(walk.steps.begin(), WalkStep{TraceStep::start});
    const bool same = std::ranges::equal(walk.steps, traced_, {}, &WalkStep::state, &WalkStep::state);
    if (walk_.steps.empty() || !same) return std::nullopt;
    std::uint64_t before = 0;
    for (const TableMap& map : maps) {
        if (map.pieces.empty()) continue;
        const MappedPiece& last = map.pieces.back();
        const std::uint64_t from = map.pieces.front().offset / measure::cache_line,
                            end = (last.offset + last.stride * last.count - 1) / measure::cache_line + 1;
        bool is_read = false;
        for (std::size_t i = 0; i < traced_.size(); ++i) {
            const auto& lines = traced_[i].lines;
            for (auto line = lines.lower_bound(from); line != lines.end() && *line < end; ++line)
                is_read = walk.steps[i].lines.insert(before + *line - from).second || is_read;
        }
        if (!is_read) continue;
        walk.tables.push_back(end - from);
        before += end - from;
    }
    if (walk.steps.front().lines.empty()) walk.steps.erase(walk.steps.begin());
    return walk;
}

}  // namespace edgewise::bench
