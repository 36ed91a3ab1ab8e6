// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/reuse_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgewise::measure {

namespace {

constexpr std::uint64_t word_bits = 64, first_words = 1024;

}  // namespace

std::uint64_t MissCurve::misses(std::uint64_t lines) const {
    if (lines >= at_.size()) return firsts_;
    const auto from = at_.begin() + static_cast<std::ptrdiff_t>(lines);
    return std::accumulate(from, at_.end(), firsts_);
}

std::uint64_t MissCurve::smallest_size(double misses) const {
    std::uint64_t beyond = 0;  // uses at a distance of `lines` or more
    for (std::uint64_t lines = at_.size(); lines > 0; --lines) {
        beyond += at_[lines - 1];
        if (static_cast<double>(beyond) > misses) return lines;
    }
    return 0;
}

std::vector<MissCurve::Point> MissCurve::points(std::size_t points) const {
    std::vector<Point> all;
    std::uint64_t misses = uses_;
    for (std::uint64_t lines = 0; lines < at_.size(); ++lines) {
        if (lines > 0 && at_[lines - 1] != 0) all.push_back({lines, misses});
        misses -= at_[lines];
    }
    if (!at_.empty() && at_.back() != 0) all.push_back({at_.size(), misses});
    if (all.size() <= points || points < 2) return all;
    // The last point of each step of the logarithm says what a cache of that size misses.
    std::vector<Point> some;
    const double span = std::log(static_cast<double>(all.back().lines));
    const double steps = static_cast<double>(points - 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto step = [&](const Point& point) {
            return span > 0 ? std::floor(std::log(static_cast<double>(point.lines)) / span * steps) : 0;
        };
        if (i + 1 == all.size() || step(all[i]) != step(all[i + 1])) some.push_back(all[i]);
    }
    return some;
}

void ReuseDistance::set(std::uint64_t time) {
    words_[time / word_bits] |= std::uint64_t{1} << time % word_bits;
    for (std::uint64_t i = time / word_bits + 1; i < tree_.size(); i += i & (0 - i)) ++tree_[i];
}

void ReuseDistance::clear(std::uint64_t time) {
    words_[time / word_bits] &= ~(std::uint64_t{1} << time % word_bits);
    for (std::uint64_t i = time / word_bits + 1; i < tree_.size(); i += i & (0 - i)) --tree_[i];
}

std::uint64_t ReuseDistance::count_to(std::uint64_t time) const {
    const std::uint64_t within = words_[time / word_bits] << (word_bits - 1 - time % word_bits);
    auto sum = static_cast<std::uint64_t>(std::popcount(within));
    for (std::uint64_t i = time / word_bits; i > 0; i &= i - 1) sum += tree_[i];
    return sum;
}

/// Renumbers last uses from time 0 in their order; at least twice that number of free times follow.
void ReuseDistance::compact() {
    std::vector<std::uint64_t> lines;
    for (std::uint64_t line = 0; line < last_use_.size(); ++line) {
        if (last_use_[line] != 0) lines.push_back(line);
    }
    std::ranges::sort(lines, {}, [this](std::uint64_t line) { return last_use_[line]; });
    words_.assign(std::max(first_words, 3 * lines.size() / word_bits + 1), 0);
    tree_.assign(words_.size() + 1, 0);
    for (now_ = 0; now_ < lines.size(); ++now_) {
        last_use_[lines[now_]] = now_ + 1;
        words_[now_ / word_bits] |= std::uint64_t{1} << now_ % word_bits;
    }
    for (std::uint64_t i = 1; i < tree_.size(); ++i) {
        tree_[i] += static_cast<std::uint64_t>(std::popcount(words_[i - 1]));
        const std::uint64_t above = i + (i & (0 - i));
        if (above < tree_.size()) tree_[above] += tree_[i];
    }
}

std::uint64_t ReuseDistance::use_another(std::uint64_t line) {
    last_line_ = line;
    if (now_ == words_.size() * word_bits) compact();
    if (line >= last_use_.size()) last_use_.resize(std::max(line + 1, 2 * last_use_.size()), 0);
    std::uint64_t distance = never;
    if (const std::uint64_t before = last_use_[line]; before != 0) {
        distance = live_ - count_to(before - 1);
        clear(before - 1);
        curve_.add(distance);
    } else {
        ++live_;
        curve_.add_first();
    }
    set(now_);
    last_use_[line] = ++now_;
    return distance;
}

}  // namespace edgewise::measure
