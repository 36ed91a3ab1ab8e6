// SPDX-License-Identifier: MIT
//
// Sort and sweep over persistent orders. Ties go by body number, so the order never depends on the past.
#include "edgewise/algorithms/sweep_and_prune.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace edgewise {
namespace {

/// How far the boxes' centres scatter along an axis (their variance, up to constants).
double spread(int axis, std::span<const Aabb> boxes) {
    const double count = static_cast<double>(boxes.size());
    double mean = 0;
    for (const Aabb& box : boxes) mean += (box.low[axis] + box.high[axis]) / count;
    double sum = 0;
    for (const Aabb& box : boxes) {
        const double off = box.low[axis] + box.high[axis] - mean;
        sum += off * off;
    }
    return sum;
}

}  // namespace

SweepAndPrune::SweepAndPrune(std::size_t body_count) {
    for (std::vector<std::uint32_t>& order : order_) {
        order.resize(body_count);
        std::iota(order.begin(), order.end(), 0U);
    }
}

std::span<const BodyPair> SweepAndPrune::update(std::span<const Aabb> boxes) {
    assert(boxes.size() == order_[0].size());
    moves_ = 0;
    int widest = 0;
    double most = -1;
    for (int axis = 0; axis < 3; ++axis) {
        sort_axis(axis, boxes);
        const double scatter = spread(axis, boxes);
        if (scatter > most) {
            most = scatter;
            widest = axis;
        }
    }
    sweep_axis(widest, boxes);
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

void SweepAndPrune::sort_axis(int axis, std::span<const Aabb> boxes) {
    std::vector<std::uint32_t>& order = order_[static_cast<std::size_t>(axis)];
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        const double low_a = boxes[a].low[axis];
        const double low_b = boxes[b].low[axis];
        return low_a < low_b || (low_a == low_b && a < b);
    };
    for (std::size_t i = 1; i < order.size(); ++i) {
        const std::uint32_t body = order[i];
        std::size_t place = i;
        for (; place > 0 && before(body, order[place - 1]); --place) order[place] = order[place - 1];
        order[place] = body;
        moves_ += i - place;
    }
}

void SweepAndPrune::sweep_axis(int axis, std::span<const Aabb> boxes) {
    const std::vector<std::uint32_t>& order = order_[static_cast<std::size_t>(axis)];
    pairs_.clear();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Aabb& box = boxes[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            if (boxes[order[j]].low[axis] > box.high[axis]) break;
            if (!box.overlaps(boxes[order[j]])) continue;
            pairs_.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
        }
    }
}

}  // namespace edgewise
