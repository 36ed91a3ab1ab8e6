// SPDX-License-Identifier: MIT
//
// Answers of GJK that take no run: from the last query's simplex, from where a search in singles ended, or
// along one direction. Each is proven, or else the run starts (gjk.hpp). Only small bodies are tried: on
// large ones climbs cost more than such answers save. The paper's algorithm (Johnson's search) has none.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/gjk_start.hpp"
#include "edgewise/algorithms/kept_simplex.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/search/single_search.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/inlining.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

/// Steps taken before a run of GJK starts.
struct EarlySteps {
    int taken = 0;     ///< of the search in singles
    int observed = 0;  ///< already reported to the observer
};

/// Looks for the answer to one query without a run. Tables, pose and options must live longer.
template <SupportTable TableA, SupportTable TableB>
class EarlyAnswer {
  public:
    using Scalar = ComputeOf<TableA>;
    using Pair = SimplexPair<TableA, TableB>;

    EarlyAnswer(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b,
                const QueryOptions& options)
        : a_(a), b_(b), a_from_b_(a_from_b), options_(options), cutoff_(options.cutoff_in<Scalar>()) {
        assert(options.contact_tolerance >= 0 && options.gap_tolerance >= 0 && options.cutoff >= 0);
    }

    [[nodiscard]] const EarlySteps& steps() const { return steps_; }

    /// Answers from the last query's simplex, in doubles, if that provably holds the closest points still.
    template <class Observer>
    [[nodiscard]] bool from_last(Pair& pair, Distance& answer, Observer& observer) {
        if (!may_try()) return false;
        starts_near_ = pair.starts_warm(a_, b_);
        if (!starts_near_) return false;
        return from_corners(
            pair, answer, [&](auto& kept) __attribute__((always_inline)) {
                const bool rests = kept.rests_on_all();
                starts_near_ = kept.least_weight() >= -far_off_weight &&
                               !is_farther(kept.squared_distance(), double{pair.distance()}, kept.size());
                if (!rests || !starts_near_) return false;
                observer.iterate(kept.closest().members);
                steps_.observed = 1;
                return true;
            });
    }

    /// Returns true if a search in singles may find where a run starts: the pair is cold, or its simplex
    /// is far off. (From a near one a search takes as long as the run: 8 vertices, 0.1 rad per step, 1.01.)
    [[nodiscard]] bool may_search() const { return !starts_near_ && may_try(); }

    /// Searches in singles for where a run starts, where may_search().
    [[nodiscard]] SingleSearchEnd search() const {
        SingleSearchEnd end;
        search_in_singles(a_, b_, a_from_b_, cutoff_, end);
        return end;
    }

    /// Answers from where a search ended, if that is proven; else the run starts there.
    [[nodiscard]] bool from_end(const SingleSearchEnd& end, Pair& pair, Distance& answer) {
        steps_.taken = steps_.observed = end.steps;
        pair.hold(a_, b_, end, std::numeric_limits<double>::infinity());
        if (options_.has_cutoff() && along_one_direction(pair, answer) != 0) return true;
        return from_corners(
            pair, answer, [](auto& kept) __attribute__((always_inline)) { return kept.rests_on_all(); });
    }

    /// Answers if the bodies are beyond the cutoff along the direction of the pair's simplex, or, of a cold
    /// pair, along the line of the origins. Returns which points gave the direction; 0 without an answer.
    [[nodiscard]] PointMask along_one_direction(const Pair& pair, Distance& answer) const {
        const auto look = [&]() __attribute__((noinline)) { return look_along(pair, answer); };
        if constexpr (is_traced<TableA>)
            return look();
        else
            return look_along_inlined(pair, answer);
    }

  private:
    [[nodiscard]] bool may_try() const {
        return options_.sub_distance == SubDistanceSolver::cofactors && is_small(a_) && is_small(b_);
    }

    [[nodiscard]] PointMask look_along(const Pair& pair, Distance& answer) const {
        if (!may_try()) return 0;
        const std::uint32_t count = pair.starts_warm(a_, b_) ? pair.count() : 0;
        if (count == 4 || !(double{cutoff_} < double{pair.distance()})) return 0;  // they are nearer
        KeptSimplex<TableA, TableB, double> kept(a_, b_, a_from_b_);
        for (std::uint32_t i = 0; i < count; ++i) kept.push(pair.corner(i).a, pair.corner(i).b);
        if (count == 0) kept.push(a_.first_vertex(), b_.first_vertex());
        const Vec3d direction = count > 0 ? kept.direction() : Vec3d(-cast<double>(a_from_b_.translation));
        if (!kept.is_beyond(double{cutoff_}, direction)) return 0;
        answer = kept.answer_beyond(direction);
        answer.steps = std::max(steps_.taken, 1);
        return static_cast<PointMask>((1 << kept.count) - 1);
    }

    /// Not part of its caller: that made queries for the distance a tenth longer (instructions).
    [[nodiscard]] EDGEWISE_QUERY_LOOP PointMask look_along_inlined(const Pair& pair, Distance& answer) const {
        return look_along(pair, answer);
    }

    /// Answers from the corners of the pair if is_worth_it(kept) and the proof holds; never without corners,
    /// or from four, which surround the origin. Each number of corners has code of its own, whose values all
    /// stay in registers: 0.9 of a query's time. Traced tables, whose time is not measured, do without.
    template <class IsWorthIt>
    [[nodiscard]] [[gnu::always_inline]] bool from_corners(Pair& pair, Distance& answer,
                                                           const IsWorthIt& is_worth_it) const {
        const auto try_some = [&](auto number) __attribute__((always_inline)) {
            KeptSimplex<TableA, TableB, double> kept(a_, b_, a_from_b_);
            const std::uint32_t count = number;
#pragma GCC unroll 3
            for (std::uint32_t i = 0; i < count; ++i) kept.push(pair.corner(i).a, pair.corner(i).b);
            if (!is_worth_it(kept)) return false;
            if (!kept.is_proven(options_)) return false;
            kept.write(answer);
            answer.steps = std::max(steps_.taken, 1);
            pair.set_distance(answer.distance);
            return true;
        };
        const std::uint32_t count = pair.count();
        if constexpr (is_traced<TableA>) {
            return count - 1 < 3 && try_some(count);
        } else {
            if (count == 3) return try_some(std::integral_constant<std::uint32_t, 3>());
            if (count == 2) return try_some(std::integral_constant<std::uint32_t, 2>());
            return count == 1 && try_some(std::integral_constant<std::uint32_t, 1>());
        }
    }

    const TableA& a_;
    const TableB& b_;
    const Transform<Scalar>& a_from_b_;
    const QueryOptions& options_;
    Scalar cutoff_;
    EarlySteps steps_;
    bool starts_near_ = false;  ///< true if the pair's simplex may hold the closest points still
};

}  // namespace edgewise
