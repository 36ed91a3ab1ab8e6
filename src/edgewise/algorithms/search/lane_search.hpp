// SPDX-License-Identifier: MIT
//
// The search of single_search.cpp for several pairs side by side, one per lane, without a branch on which
// lanes could disagree. When its search ends, a lane takes the next one, so that none waits for another.
// Every result is that of a single search.
#pragma once

#include <bit>
#include <limits>

#include "edgewise/algorithms/search/lane_bodies.hpp"
#include "edgewise/algorithms/search/lane_vector.hpp"
#include "edgewise/algorithms/search/sides.hpp"
#include "edgewise/algorithms/search/single_search.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// A search that takes more has lost its way in rounding.
inline constexpr int most_search_steps = 32;
/// Duality gap, times |v| and the farthest coordinate, that rounding to singles leaves open; and how many of
/// these a reach must exceed for a verdict.
inline constexpr float search_gap = 0x1.4p-21F, clear_gaps = 16;

class LaneSearch {
  public:
    explicit LaneSearch(SearchSource& source) : source_(source) {}

    /// Runs all searches of the source.
    [[gnu::always_inline]] void run() {
        for (EightWords done = EightWords{} - 1;; done = iterate()) {
            start(done);
            if (lane_bits(is_active_) == 0) return;
        }
    }

  private:
    /// Adds one support point in every lane. Returns the lanes whose search is done.
    [[gnu::always_inline]] EightWords iterate() {
        const auto a = a_.farthest<false>(v_), b = b_.farthest<true>(v_);
        const LaneVec p = a.point - b.point;
        const EightWords pair = a.vertex << 8 | b.vertex;
        const EightWords ended = ends(p, pair);
        const Sides<Three<Eight>> sides({same(p.x), same(p.y), same(p.z)}, older(), held_);
        const EightWords surrounded =
            sides.inside.of[0] & sides.inside.of[1] & sides.inside.of[2] & ~ended & ~starts_;
        const EightWords done = is_active_ & (ended | surrounded);
        hand_over(done, surrounded, pair);
        rest_on(sides, p, is_active_ & ~starts_ & ~done);
        insert(p, pair);
        extent_ = starts_ ? max_abs(b.point) : extent_;
        steps_ += 1;
        return done;
    }

    [[nodiscard, gnu::always_inline]] static Three<Eight> same(const Eight& of) { return {{of, of, of}}; }
    [[nodiscard, gnu::always_inline]] OfOlder<Three<Eight>> older() const {
        return {{{q_[0].x, q_[1].x, q_[2].x}}, {{q_[0].y, q_[1].y, q_[2].y}}, {{q_[0].z, q_[1].z, q_[2].z}}};
    }

    /// Mask of the lanes that have nothing left to gain.
    [[nodiscard, gnu::always_inline]] EightWords ends(const LaneVec& p, const EightWords& pair) {
        const Eight squared = squared_norm(v_), reach = dot(v_, p) * scale_,
                    open = search_gap * extent_ * scale_ * square_root(squared),
                    length = squared / (scale_ * scale_);
        EightWords ended = (squared - reach <= open) | ~(length < least_) | (steps_ > most_search_steps);
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) ended |= held_.of[i] & (pairs_[i] == pair);
        least_ = starts_ ? least_ : length;
        return ended & ~starts_;
    }

    /// Computes the closest points: of lanes that start, the newest point.
    [[gnu::always_inline]] void rest_on(const Sides<Three<Eight>>& sides, const LaneVec& p,
                                        const EightWords& goes_on) {
        const EightWords chosen = -(sides.face.of[0] + sides.face.of[1] + sides.face.of[2] +
                                    sides.edge.of[0] + sides.edge.of[1] + sides.edge.of[2]);
        const EightWords on_newest =
            starts_ | ((chosen == 0) & ~(sides.ahead.of[0] | sides.ahead.of[1] | sides.ahead.of[2]));
        const Three<Eight> scales = sides.scale();
        Three<Eight> weight = sides.weight();
        Three<EightWords> members = sides.members();
        scale_ =
            on_newest
                ? Eight{} + 1
                : (Eight)((EightWords)scales.of[0] | (EightWords)scales.of[1] | (EightWords)scales.of[2]);
        const EightWords in_doubt = goes_on & ~on_newest & (chosen != 1);
        try_all(in_doubt, p, weight, members);
        v_ = (scale_ * p + weight.of[0] * (q_[0] - p)) +
             (weight.of[1] * (q_[1] - p) + weight.of[2] * (q_[2] - p));
        held_ = members & Three<EightWords>{{~starts_, ~starts_, ~starts_}};
    }

    [[gnu::always_inline]] void try_all(const EightWords& in_doubt, const LaneVec& p, Three<Eight>& weight,
                                        Three<EightWords>& members) {
        for (unsigned left = lane_bits(in_doubt); left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            OfOlder<Four> older{};
            FourWords held{};
            for (int i = 0; i < 3; ++i) {
                older.x[i] = q_[i].x[lane];
                older.y[i] = q_[i].y[lane];
                older.z[i] = q_[i].z[lane];
                held[i] = held_.of[i][lane];
            }
            const NearestOfAll nearest = try_all_sides(Four{p.x[lane], p.y[lane], p.z[lane], 0}, older, held);
            scale_[lane] = nearest.scale;
            for (int i = 0; i < 3; ++i) {
                weight.of[i][lane] = nearest.weight[i];
                members.of[i][lane] = nearest.members[i];
            }
        }
    }

    /// Puts the newest point in the first free place.
    [[gnu::always_inline]] void insert(const LaneVec& p, const EightWords& pair) {
        EightWords taken = EightWords{} - 1;
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) {
            const EightWords here = taken & ~held_.of[i];
            q_[i] = select(here, p, q_[i]);
            pairs_[i] = here ? pair : pairs_[i];
            taken &= held_.of[i];
            held_.of[i] |= here;
        }
    }

    /// Hands over the searches that are done.
    [[gnu::always_inline]] void hand_over(const EightWords& done, const EightWords& surrounded,
                                          const EightWords& pair) {
        for (unsigned left = lane_bits(done); left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            SingleSearchEnd end;
            end.steps = static_cast<int>(steps_[lane]);
            for (int i = 0; i < 3; ++i) end.add(pairs_[i][lane], held_.of[i][lane] != 0);
            if (surrounded[lane]) end.add(pair[lane], true);
            source_.take(lane, end);
        }
    }

    /// Starts the source's next searches in these lanes; a lane without one is idle.
    [[gnu::always_inline]] void start(const EightWords& lanes) {
        LaneVec first = v_;
        for (unsigned left = lane_bits(lanes); left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            SingleSearch& search = searches_[lane];
            is_active_[lane] = source_.next(lane, search) ? -1 : 0;
            if (is_active_[lane] == 0) continue;
            a_.write(lane, search.a);
            Rows<lane_count>::move_to_a(search, search.b);
            b_.write(lane, search.b);
            first.set(lane, -search.towards_b.x(), -search.towards_b.y(), -search.towards_b.z());
        }
        v_ = first;
        held_ = held_ & ~Three<EightWords>{{lanes, lanes, lanes}};
        least_ = lanes ? Eight{} + std::numeric_limits<float>::infinity() : least_;
        steps_ = lanes ? EightWords{} + 1 : steps_;
        starts_ = lanes;
    }

    SearchSource& source_;
    SmallArray<SingleSearch, lane_count> searches_;  ///< B in A's frame
    LaneBodies a_, b_;                               ///< both in A's frame
    SmallArray<LaneVec, 3> q_{};
    SmallArray<EightWords, 3> pairs_{};
    Three<EightWords> held_{};
    LaneVec v_{};  ///< the simplex' closest point, times scale
    Eight scale_{}, least_{}, extent_{};
    EightWords steps_{};
    EightWords starts_{};     ///< without a point so far
    EightWords is_active_{};  ///< holds a search
};

}  // namespace edgewise
