// SPDX-License-Identifier: MIT
//
// Broad phase: which axis-aligned boxes overlap. Sort and sweep (Baraff 1992; Cohen, Lin, Manocha, Ponamgi
// 1995).
//
// The boxes' low ends are kept sorted on all three axes from frame to frame; insertion sort repairs the order
// in linear time while motion is coherent. The sweep runs along the axis on which the boxes spread most and
// tests the other two directly. Departs from I-COLLIDE, which sweeps all three axes and keeps overlap
// counters per pair: that costs memory for every pair, where this costs a few comparisons for every near
// pair.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "edgewise/geometry/aabb.hpp"

namespace edgewise {

struct BodyPair {
    std::uint32_t first, second;  ///< first < second

    [[nodiscard]] auto operator<=>(const BodyPair&) const = default;
};

/// The arrays that an update reads and writes.
enum class BroadPhaseArray : std::uint8_t { boxes, order_x, order_y, order_z, pairs };
inline constexpr std::size_t broad_phase_arrays = 5;

/// Range of bytes of an element.
struct ElementPart {
    std::size_t offset, bytes;
};

/// Is notified of every read and write; costs nothing. (Not of the last sort of the pairs: there are few, and
/// they have just been written.)
struct NoTouches {
    static void read(BroadPhaseArray, std::size_t /*element*/, ElementPart) {}
    static void write(BroadPhaseArray, std::size_t /*element*/, ElementPart) {}
};

class SweepAndPrune {
  public:
    explicit SweepAndPrune(std::size_t body_count) {
        for (std::vector<std::uint32_t>& order : order_) {
            order.resize(body_count);
            std::iota(order.begin(), order.end(), 0U);
        }
    }

    /// The overlapping pairs of one frame, sorted; valid until the next call. One box per body, none with
    /// NaN.
    template <class Touches = NoTouches>
    [[nodiscard]] std::span<const BodyPair> update(std::span<const Aabb> boxes, Touches&& touches = {}) {
        assert(boxes.size() == order_[0].size());
        moves_ = 0;
        int widest = 0;
        double most = -1;
        for (int axis = 0; axis < 3; ++axis) {
            sort_axis(axis, boxes, touches);
            const double scatter = spread(axis, boxes, touches);
            if (scatter > most) {
                most = scatter;
                widest = axis;
            }
        }
        sweep_axis(widest, boxes, touches);
        std::sort(pairs_.begin(), pairs_.end());
        return pairs_;
    }

    /// Places that insertion sort moved in the last update, over all axes: the cost of lost coherence.
    [[nodiscard]] std::size_t moves() const { return moves_; }
    /// Pairs of boxes with ends that the last update compared on the axis it swept.
    [[nodiscard]] std::size_t tests() const { return tests_; }

  private:
    [[nodiscard]] static BroadPhaseArray order_array(int axis) {
        return static_cast<BroadPhaseArray>(static_cast<int>(BroadPhaseArray::order_x) + axis);
    }
    static constexpr ElementPart body_number{0, sizeof(std::uint32_t)}, whole_box{0, sizeof(Aabb)},
        whole_pair{0, sizeof(BodyPair)};
    [[nodiscard]] static ElementPart low_end(int axis) {
        return {static_cast<std::size_t>(axis) * sizeof(double), sizeof(double)};
    }
    [[nodiscard]] static ElementPart high_end(int axis) {
        return {static_cast<std::size_t>(axis + 3) * sizeof(double), sizeof(double)};
    }

    /// Variance of the boxes' centres along an axis, up to constants.
    template <class Touches>
    [[nodiscard]] static double spread(int axis, std::span<const Aabb> boxes, Touches& touches) {
        const auto ends = [&](std::size_t i) {
            touches.read(BroadPhaseArray::boxes, i, low_end(axis));
            touches.read(BroadPhaseArray::boxes, i, high_end(axis));
            assert(boxes[i].low[axis] <= boxes[i].high[axis] && "low ends first, and no NaN");
            return boxes[i].low[axis] + boxes[i].high[axis];
        };
        const double count = static_cast<double>(boxes.size());
        double mean = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) mean += ends(i) / count;
        double sum = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const double off = ends(i) - mean;
            sum += off * off;
        }
        return sum;
    }

    /// Sorts an axis. Ties go by body number, so the order never depends on the past.
    template <class Touches>
    void sort_axis(int axis, std::span<const Aabb> boxes, Touches& touches) {
        std::vector<std::uint32_t>& order = order_[static_cast<std::size_t>(axis)];
        const BroadPhaseArray array = order_array(axis);
        const auto before = [&](std::uint32_t a, std::uint32_t b) {
            touches.read(BroadPhaseArray::boxes, b, low_end(axis));
            const double low_a = boxes[a].low[axis];
            const double low_b = boxes[b].low[axis];
            return low_a < low_b || (low_a == low_b && a < b);
        };
        for (std::size_t i = 1; i < order.size(); ++i) {
            const std::uint32_t body = order[i];
            touches.read(array, i, body_number);
            touches.read(BroadPhaseArray::boxes, body, low_end(axis));
            std::size_t place = i;
            for (; place > 0; --place) {
                touches.read(array, place - 1, body_number);
                if (!before(body, order[place - 1])) break;
                order[place] = order[place - 1];
                touches.write(array, place, body_number);
            }
            if (place == i) continue;
            order[place] = body;
            touches.write(array, place, body_number);
            moves_ += i - place;
        }
    }

    template <class Touches>
    void sweep_axis(int axis, std::span<const Aabb> boxes, Touches& touches) {
        const std::vector<std::uint32_t>& order = order_[static_cast<std::size_t>(axis)];
        const auto box_at = [&](std::size_t i, ElementPart part) -> const Aabb& {
            touches.read(order_array(axis), i, body_number);
            touches.read(BroadPhaseArray::boxes, order[i], part);
            return boxes[order[i]];
        };
        pairs_.clear();
        tests_ = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Aabb& box = box_at(i, whole_box);
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const Aabb& other = box_at(j, low_end(axis));
                ++tests_;
                if (other.low[axis] > box.high[axis]) break;
                touches.read(BroadPhaseArray::boxes, order[j], whole_box);
                assert(order[i] != order[j]);
                if (!box.overlaps(other)) continue;
                touches.write(BroadPhaseArray::pairs, pairs_.size(), whole_pair);
                pairs_.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
            }
        }
    }

    std::array<std::vector<std::uint32_t>, 3> order_;  ///< bodies by low end, per axis
    std::vector<BodyPair> pairs_;
    std::size_t moves_ = 0, tests_ = 0;
};

}  // namespace edgewise
