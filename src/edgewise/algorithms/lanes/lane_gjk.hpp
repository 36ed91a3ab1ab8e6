// SPDX-License-Identifier: MIT
//
// Enhanced GJK for several pairs side by side: GjkRun (gjk.hpp), one query per lane, without a branch on
// which lanes could disagree. When its query ends, a lane takes the next one, so that none waits for another.
// Every query starts cold. Rare cases (contact, a close or thin simplex) are not computed here: the query is
// asked by itself, from its start. So every answer is to the bit that of a single query.
#pragma once

#include "edgewise/algorithms/lanes/lane_closest.hpp"
#include "edgewise/algorithms/lanes/lane_source.hpp"
#include "edgewise/algorithms/lanes/lane_state.hpp"
#include "edgewise/algorithms/lanes/lane_vector.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {

template <class Scalar, int n>
class LaneGjk {
  public:
    using Number = Numbers<Scalar, n>;
    using Mask = Masks<Scalar, n>;
    using Vector = LaneVec<Scalar, n>;

    LaneGjk(LaneSource<Scalar>& source, const QueryOptions& options)
        : source_(source),
          contact_squared_(static_cast<Scalar>(options.contact_tolerance * options.contact_tolerance)),
          gap_(static_cast<Scalar>(options.gap_tolerance)),
          verdict_only_(options.verdict_only) {}

    /// Runs all queries of the source.
    [[gnu::always_inline]] void run() {
        for (int lane = 0; lane < n; ++lane) lanes_.load(lane, source_);
        while (any_lane(lanes_.is_active)) iterate();
    }

  private:
    static constexpr int most_steps = 64;  ///< a query that takes more is not for lanes

    /// Adds one support point in every lane; a query's first lies along the line of the origins.
    [[gnu::always_inline]] void iterate() {
        lanes_.steps -= ~lanes_.starts;
        const Vector v = select(lanes_.starts, -lanes_.translation, lanes_.closest);
        const Number squared = squared_norm(v);
        const auto a = lanes_.a.farthest(-v), b = lanes_.b.farthest(lanes_.direction_back(v));
        const Vector on_b = lanes_.point_of_b(b.point);
        const Vector difference = a.point - on_b;
        const Mask both = a.vertex << 16 | b.vertex;
        const auto [ended, doubted] = ends(v, squared, dot(v, difference), lanes_.holds(both));
        if (any_lane(ended)) take(ended);
        lanes_.push(both, difference);
        const Number size = larger(lanes_.size, larger(max_abs(a.point), max_abs(on_b)));
        const LaneClosest<Scalar, n> closest(lanes_.difference, lanes_.count);
        lanes_.closest = select(lanes_.starts, difference, closest.point());
        const Number close = Tolerance<Scalar>::close * size, left = squared_norm(lanes_.closest);
        const Mask gains = lanes_.starts | (left < squared);
        const Mask single = doubted | ~(closest.sure() & (left >= close * close) & gains);
        lanes_.keep(closest, size, ended);
        const Mask alone = single & lanes_.is_active & ~ended;
        if (any_lane(alone)) ask_singly(alone);
    }

    struct Ends {
        Mask ended, doubted;  ///< nothing left to gain; to be asked by themselves
    };

    [[nodiscard]] [[gnu::always_inline]] Ends ends(const Vector& v, const Number& squared,
                                                   const Number& reach, const Mask& held) const {
        const Number length = square_root<Scalar, n>(squared) * lanes_.size;
        const Number noise = Tolerance<Scalar>::support_noise * length;
        const Mask separates = reach > noise;
        Mask verdict{};
        if (verdict_only_) verdict = reach - noise > square_root<Scalar, n>(contact_squared_ * squared);
        const Mask touching = (max_abs(v) <= Tolerance<Scalar>::contact_noise * lanes_.size) & ~separates;
        const Mask decided =
            verdict |
            (squared - reach <= larger(Number(Tolerance<Scalar>::open_gap * length), Number(gap_ * squared)));
        const Mask doubted = ~lanes_.starts & ((squared <= contact_squared_) | (decided & touching) |
                                               (held & ~decided) | (lanes_.steps > most_steps));
        return {decided & ~doubted & ~lanes_.starts & lanes_.is_active, doubted};
    }

    /// Takes the answers of the ended lanes; the start of their next queries stays until all step again.
    [[gnu::always_inline]] void take(const Mask& ended) {
        for (int lane = 0; lane < n; ++lane) {
            if (!ended[lane]) continue;
            source_.take(lane, lanes_.answer(lane));
            lanes_.load(lane, source_);
        }
    }

    [[gnu::always_inline]] void ask_singly(const Mask& alone) {
        for (int lane = 0; lane < n; ++lane) {
            if (!alone[lane]) continue;
            source_.ask_singly(lane);
            lanes_.load(lane, source_);
        }
    }

    LaneSource<Scalar>& source_;
    Scalar contact_squared_, gap_;  ///< QueryOptions
    bool verdict_only_;
    LaneState<Scalar, n> lanes_;
};

}  // namespace edgewise
