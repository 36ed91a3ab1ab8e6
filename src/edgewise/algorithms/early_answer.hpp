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

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/gjk_start.hpp"
#include "edgewise/algorithms/kept_simplex.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/search/single_search.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Steps taken before a run of GJK starts.
struct EarlySteps {
    bool starts_near = false;  ///< true if the pair's simplex may hold the closest points still
    int taken = 0;             ///< of the search in singles
    int observed = 0;          ///< already reported to the observer
};

/// Looks for the answer to one query without a run. Tables, pose and options must live longer.
template <SupportTable TableA, SupportTable TableB>
class EarlyAnswer {
  public:
    using Scalar = ComputeOf<TableA>;
    using Pair = SimplexPair<TableA, TableB>;

    EarlyAnswer(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b,
                const QueryOptions& options, EarlySteps steps = {})
        : a_(a),
          b_(b),
          a_from_b_(a_from_b),
          options_(options),
          cutoff_(options.cutoff_in<Scalar>()),
          steps_(steps) {
        assert(options.contact_tolerance >= 0 && options.gap_tolerance >= 0 && options.cutoff >= 0);
    }

    [[nodiscard]] const EarlySteps& steps() const { return steps_; }

    /// Answers from the last query's simplex, in doubles, if that provably holds the closest points still.
    template <class Observer>
    [[nodiscard]] bool from_last(Pair& pair, Distance& answer, Observer& observer) {
        if (!may_try()) return false;
        steps_.starts_near = pair.starts_warm(a_, b_);
        if (!steps_.starts_near) return false;
        return ask_corners(
            a_, b_, a_from_b_, pair, [&](auto& kept) __attribute__((always_inline)) {
                const bool rests = kept.rests_on_all();
                steps_.starts_near =
                    kept.least_weight() >= -far_off_weight &&
                    !is_farther(kept.squared_distance(), double{pair.distance()}, kept.size());
                if (!rests || !steps_.starts_near) return false;
                observer.iterate(kept.closest().members);
                steps_.observed = 1;
                return answer_if_proven(kept, pair, answer);
            });
    }

    /// Searches in singles for where to start, unless a search has already run or the pair's simplex is
    /// near, and answers from there.
    template <class Observer>
    [[nodiscard]] bool from_search(Pair& pair, Distance& answer, Observer& observer) {
        if constexpr (NumberedTable<TableA> && NumberedTable<TableB>) {
            if (steps_.starts_near || steps_.taken > 0 || !may_try()) return false;
            observer.search();
            SingleSearch search;
            write_search(a_, b_, a_from_b_, cutoff_, search);
            return from_end(run_single_search(search), pair, answer);
        }
        return false;
    }

    /// Answers from where a search ended, if that is proven; else the run starts there.
    [[nodiscard]] bool from_end(const SingleSearchEnd& end, Pair& pair, Distance& answer) {
        steps_.taken = steps_.observed = end.steps;
        pair.hold(a_, b_, end, std::numeric_limits<double>::infinity());
        return ask_corners(
            a_, b_, a_from_b_, pair, [&](auto& kept) __attribute__((always_inline)) {
                if (options_.has_cutoff() && answer_if_beyond(kept, kept.direction(), answer)) return true;
                return kept.rests_on_all() && answer_if_proven(kept, pair, answer);
            });
    }

    /// Answers if the bodies are beyond the cutoff along the direction of the last simplex, or, of a cold
    /// pair, along the line of the origins. The pair stays as it is. Not inlined: inlined, it made
    /// queries for the distance a tenth longer (instructions).
    template <class Observer>
    [[nodiscard]] EDGEWISE_QUERY_LOOP bool along_one_direction(const Pair& pair, Distance& answer,
                                                               Observer& observer) const {
        if (!may_try()) return false;
        const std::uint32_t count = pair.starts_warm(a_, b_) ? pair.count() : 0;
        if (count == 4 || !(double{cutoff_} < double{pair.distance()})) return false;  // they are nearer
        KeptSimplex<TableA, TableB, double> kept(a_, b_, a_from_b_);
        for (std::uint32_t i = 0; i < count; ++i) kept.push(pair.corner(i).a, pair.corner(i).b);
        if (count == 0) kept.push(a_.first_vertex(), b_.first_vertex());
        const Vec3d direction = count > 0 ? kept.direction() : Vec3d(-cast<double>(a_from_b_.translation));
        if (!answer_if_beyond(kept, direction, answer)) return false;
        observer.iterate(static_cast<PointMask>((1 << kept.count) - 1));
        return true;
    }

  private:
    [[nodiscard]] bool may_try() const {
        return options_.sub_distance == SubDistanceSolver::cofactors && is_small(a_) && is_small(b_);
    }

    template <class Kept>
    [[nodiscard]] bool answer_if_beyond(const Kept& kept, const Vec3d& direction, Distance& answer) const {
        if (!kept.is_beyond(double{cutoff_}, direction)) return false;
        answer = kept.answer_beyond(direction);
        answer.steps = std::max(steps_.taken, 1);
        return true;
    }

    template <class Kept>
    [[nodiscard]] [[gnu::always_inline]] bool answer_if_proven(Kept& kept, Pair& pair,
                                                               Distance& answer) const {
        if (!kept.is_proven(options_)) return false;
        kept.write(answer);
        answer.steps = std::max(steps_.taken, 1);
        pair.set_distance(answer.distance);
        return true;
    }

    const TableA& a_;
    const TableB& b_;
    const Transform<Scalar>& a_from_b_;
    const QueryOptions& options_;
    Scalar cutoff_;
    EarlySteps steps_;
};

}  // namespace edgewise
