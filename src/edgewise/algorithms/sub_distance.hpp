// SPDX-License-Identifier: MIT
//
// GJK's sub-distance: the simplex while a query runs, and its point nearest to the origin, by the chosen
// solver (query_options.hpp), in arithmetic as wide as needed. Thin and undecided simplices are solved
// in wider arithmetic, and so is every one after rounding first hides a gain. Close ones are, too, once the
// answer of a run without it was not proven (GjkRun::is_proven).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <type_traits>

#include "edgewise/algorithms/cofactors.hpp"
#include "edgewise/algorithms/johnson.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/geometry/double_double.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// Up to four pairs of vertices, and their points in the Minkowski difference (A's frame). The points of the
/// bodies stay in their own places as long as they belong to it; only their differences are kept in order,
/// because the next iteration reads only these.
template <SupportTable TableA, SupportTable TableB>
class Simplex {
  public:
    using Scalar = ComputeOf<TableA>;

    int count = 0;
    SimplexPoints<Scalar> difference;
    Scalar size = 0;  ///< longest coordinate of all points pushed so far: rounding is relative to it

    [[nodiscard]] typename TableA::Vertex vertex_a(int i) const { return vertex_a_[place_[i]]; }
    [[nodiscard]] typename TableB::Vertex vertex_b(int i) const { return vertex_b_[place_[i]]; }
    /// Points of A and B, both in A's frame.
    [[nodiscard]] const Vec3<Scalar>& on_a(int i) const { return on_a_[place_[i]]; }
    [[nodiscard]] const Vec3<Scalar>& on_b(int i) const { return on_b_[place_[i]]; }

    void clear() {
        count = 0;
        size = 0;
        taken_ = 0;
    }

    void push(typename TableA::Vertex a, typename TableB::Vertex b, const Vec3<Scalar>& point_a,
              const Vec3<Scalar>& point_b) {
        assert(count < 4);
        const auto place = static_cast<std::uint8_t>(std::countr_one(taken_));
        taken_ |= 1U << place;
        place_[count] = place;
        vertex_a_[place] = a;
        vertex_b_[place] = b;
        on_a_[place] = point_a;
        on_b_[place] = point_b;
        difference[count] = point_a - point_b;
        ++count;
        size = std::max({size, max_abs(point_a), max_abs(point_b)});
    }

    /// Undoes the last push; `before`: the size before it.
    void drop_newest(Scalar before) {
        assert(count > 0);
        --count;
        taken_ &= ~(1U << place_[count]);
        size = before;
    }

    /// Compares all pairs, because no processor can predict which of them matches.
    [[nodiscard]] bool holds(typename TableA::Vertex a, typename TableB::Vertex b) const {
        unsigned equal = 0;
#pragma GCC unroll 4
        for (unsigned i = 0; i < 4; ++i)
            equal |= (static_cast<unsigned>(vertex_a_[i] == a) & static_cast<unsigned>(vertex_b_[i] == b))
                     << i;
        return (equal & taken_) != 0;
    }

    /// Drops the points that the closest point does not rest on; weights move along. No processor can predict
    /// which points stay: all are copied down, and the next push overwrites the dropped ones.
    void keep(ClosestOfSimplex<Scalar>& closest) {
        int kept = 0;
        unsigned taken = 0;
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) {
            const unsigned stays = unsigned{closest.members} >> i & 1U;
            const std::uint8_t place = place_[i];
            taken |= stays << place;
            place_[kept] = place;
            difference[kept] = difference[i];
            closest.weight[kept] = closest.weight[i];
            kept += static_cast<int>(stays);
        }
        assert(kept > 0 && kept <= count && "a closest point rests on some vertex");
        count = kept;
        taken_ = taken;
    }

  private:
    SmallArray<std::uint8_t, 4> place_{};  ///< of each point in the following
    std::array<typename TableA::Vertex, 4> vertex_a_{};
    std::array<typename TableB::Vertex, 4> vertex_b_{};
    std::array<Vec3<Scalar>, 4> on_a_, on_b_;
    unsigned taken_ = 0;  ///< bit i: place i holds a point
};

/// Solves in wider arithmetic. In doubles all cofactors are used too, if they are the chosen solver; in sums
/// of two doubles all of them take longer than Johnson's search.
template <class Wide>
[[nodiscard]] ClosestOfSimplex<Wide> closest_in_wide(const SimplexPoints<Wide>& points, int count,
                                                     SubDistanceSolver solver) {
    if constexpr (std::is_same_v<Wide, double>) {
        if (solver == SubDistanceSolver::cofactors) {
            ClosestOfSimplex<double> found;
            find_closest(points, count, false, found);
            if (!found.thin) return found;
        }
    }
    return Johnson<Wide>(points, count).closest();
}

template <SupportTable TableA, SupportTable TableB>
class SubDistance {
  public:
    using Scalar = ComputeOf<TableA>;
    using Points = Simplex<TableA, TableB>;
    using Closest = ClosestOfSimplex<Scalar>;

    explicit SubDistance(SubDistanceSolver solver = SubDistanceSolver::cofactors)
        : solver_(solver), way_(way_of(solver)) {}

    /// Simplex without the points that the closest point does not rest on.
    [[nodiscard]] const Points& simplex() const { return simplex_; }
    [[nodiscard]] const Closest& closest() const { return closest_; }

    /// Returns true if the closest point, at this squared distance, is so close to the origin that rounding
    /// may have misled the solver.
    [[nodiscard]] bool is_close(Scalar squared) const {
        const Scalar close = Tolerance<Scalar>::close * simplex_.size;
        return squared < close * close;
    }

    /// Solves a close simplex again, and from now on every close one, in wider arithmetic. False if that is
    /// done already.
    [[nodiscard]] [[gnu::noinline]] bool solve_close_in_wide() {
        if (close_in_wide_) return false;
        close_in_wide_ = true;
        solve_wide();
        simplex_.keep(closest_);
        return true;
    }

    /// Returns to the state before the first point.
    void clear() {
        simplex_.clear();
        way_ = way_of(solver_);
        close_in_wide_ = false;
    }
    /// Adds one of a query's first points, up to four; then call solve_first().
    void add(typename TableA::Vertex a, typename TableB::Vertex b, const Vec3<Scalar>& on_a,
             const Vec3<Scalar>& on_b) {
        simplex_.push(a, b, on_a, on_b);
    }
    /// Adds the points that a pair keeps of its last query, at their present places.
    void add_last(const SimplexPair<TableA, TableB>& pair, const TableA& a, const TableB& b,
                  const Transform<Scalar>& a_from_b) {
        const std::uint32_t count = pair.count();
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto [v, w] = pair.corner(i);
            add(v, w, a.vertex(v), a_from_b.point(b.vertex(w)));
        }
    }
    void solve_first() {
        const bool by_signs = simplex_.count == 4 && way_ == Way::cofactors;
        if (!(by_signs && still_inside())) solve(false);
        simplex_.keep(closest_);
    }

    /// Adds a point of the difference; false, and nothing changed, if the closest point, at this squared
    /// distance, comes no nearer to the origin. `separates`: the bodies are known to be separated.
    [[nodiscard]] bool extend(typename TableA::Vertex a, typename TableB::Vertex b, const Vec3<Scalar>& on_a,
                              const Vec3<Scalar>& on_b, Scalar squared, bool separates) {
        const Closest closest_before = closest_;
        const Scalar size_before = simplex_.size;
        add(a, b, on_a, on_b);
        solve(true);
        if (!gains(squared) && !retry_in_wide_arithmetic(separates)) {
            simplex_.drop_newest(size_before);
            closest_ = closest_before;
            return false;
        }
        simplex_.keep(closest_);
        return true;
    }

  private:
    /// Solver of the next simplex. One word holds the solver and whether it is still trusted, so the solver
    /// costs the loop of a query no branch of its own.
    enum class Way : std::uint8_t { cofactors, johnson, wide };

    [[nodiscard]] static constexpr Way way_of(SubDistanceSolver solver) {
        return solver == SubDistanceSolver::cofactors ? Way::cofactors : Way::johnson;
    }

    /// A pair that overlapped most likely still does: four signs show it, instead of fourteen subsets.
    [[nodiscard]] bool still_inside() {
        Johnson<Scalar> johnson(simplex_.difference, simplex_.count);
        if (!johnson.holds_origin()) return false;
        closest_ = johnson.inside();
        return true;
    }

    void solve(bool newest_belongs) {
        if (way_ == Way::cofactors) {
            find_closest(simplex_.difference, simplex_.count, newest_belongs, closest_);
            if (is_sure()) return;
        } else if (way_ == Way::johnson && search()) {
            return;
        }
        solve_wide();
    }

    /// Runs Johnson's search; true if its answer will do. Out of line: called only where it was chosen.
    [[nodiscard]] [[gnu::noinline]] bool search() {
        closest_ = Johnson<Scalar>(simplex_.difference, simplex_.count).closest();
        return is_sure();
    }

    /// Returns true if the answer needs no wider arithmetic.
    [[nodiscard]] bool is_sure() {
        if (closest_.members == Johnson<Scalar>::whole) return true;
        if (closest_.backup || closest_.thin) return false;
        return !is_close(squared_norm(closest_.point)) || (!close_in_wide_ && settle_close());
    }

    /// Makes the point of a close edge orthogonal to the edge: the rounding of its weights, along the edge,
    /// would be a large part of its length. Returns false, and leaves close simplices to wider arithmetic
    /// from now on, if the point is noise even so.
    [[nodiscard]] bool settle_close() {
        if (is_edge(closest_.members)) {
            const int i = lowest_point(closest_.members), j = std::bit_width(closest_.members) - 1;
            const Vec3<Scalar> edge = simplex_.difference[j] - simplex_.difference[i];
            closest_.point -= (dot(closest_.point, edge) / squared_norm(edge)) * edge;
        }
        const Scalar noise = Tolerance<Scalar>::hardly_close * simplex_.size;
        close_in_wide_ = squared_norm(closest_.point) < noise * noise;
        return !close_in_wide_;
    }

    /// Solves again in wider arithmetic. Near the origin the cofactors cancel: the remaining direction is
    /// noise, or the wrong members are chosen and the distance grows. The points stay as they are; their
    /// rounding costs the distance no more than itself. Returns the squared distance, unrounded.
    [[gnu::noinline]] Wider<Scalar> solve_wide() {
        SimplexPoints<Wider<Scalar>> points;
        points.fill(Vec3<Wider<Scalar>>::Zero());
        for (int i = 0; i < simplex_.count; ++i) points[i] = cast<Wider<Scalar>>(simplex_.difference[i]);
        const auto wide = closest_in_wide(points, simplex_.count, solver_);
        closest_.members = wide.members;
        closest_.backup = wide.backup;
        closest_.point = cast<Scalar>(wide.point);
        for (int i = 0; i < simplex_.count; ++i) closest_.weight[i] = static_cast<Scalar>(wide.weight[i]);
        return squared_norm(wide.point);
    }

    [[nodiscard]] bool gains(Scalar before) const {
        if (closest_.members == Johnson<Scalar>::whole) return true;
        return way_ != Way::wide && squared_norm(closest_.point) < before;
    }

    /// Called when the duality gap is open but the distance did not fall. Along a valley of nearly parallel
    /// sides it falls by the square of the gap, and many steps that rounding hides add up. From here on only
    /// the unrounded distance counts, which falls strictly: the run ends. (It is kept, not computed again
    /// from the remaining simplex: for a sliver that may come out larger, and the run would cycle.) False if
    /// even so nothing is gained; unless nothing separates the bodies yet: in bodies a billionth as thick as
    /// long a direction may turn all the way they need while the distance falls by less than a part in 2^64.
    /// No step of that kind is lost, up to most_level_steps.
    [[nodiscard]] [[gnu::noinline]] bool retry_in_wide_arithmetic(bool separates) {
        if (way_ != Way::wide) {
            way_ = Way::wide;
            --simplex_.count;  // without the newest
            unrounded_ = solve_wide();
            ++simplex_.count;
        }
        const Wider<Scalar> now = solve_wide();
        if (closest_.members == Johnson<Scalar>::whole) return true;
        if (now < unrounded_) {
            unrounded_ = now;
            return true;
        }
        const bool is_level = static_cast<Scalar>(now) <= static_cast<Scalar>(unrounded_);
        const bool rests_on_newest = (closest_.members >> (simplex_.count - 1) & 1) != 0;
        return !separates && is_level && rests_on_newest && level_steps_++ < most_level_steps;
    }

    Points simplex_;
    Closest closest_;
    SubDistanceSolver solver_;
    Way way_;
    bool close_in_wide_ = false;  ///< true once an answer without wider arithmetic was not proven
    int level_steps_ = 0;         ///< number of steps that gained nothing
    Wider<Scalar> unrounded_{};   ///< squared distance, of Way::wide
};

}  // namespace edgewise
