// SPDX-License-Identifier: MIT
#include "edgewise/measure/machine/quietness.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgewise::measure {

namespace {

/// Multiplications that wait for each other: about a millisecond, the same number on every call.
double time_of_fixed_work() {
    constexpr int multiplications = 1'000'000;
    const Stopwatch watch;
    std::uint64_t state = 1;
    for (int i = 0; i < multiplications; ++i) state = state * 6364136223846793005U + 1;
    volatile std::uint64_t kept = state;
    static_cast<void>(kept);
    return watch.elapsed_ns();
}

}  // namespace

Quietness look_at_quietness() {
    constexpr double seconds = 0.25;
    std::vector<double> times;
    ShareOfOthers others;
    others.begin();
    for (const Stopwatch watch; watch.elapsed_ns() < 1e9 * seconds;) times.push_back(time_of_fixed_work());
    others.end();
    std::ranges::sort(times);
    const std::size_t middle = times.size() / 2, high = times.size() * 9 / 10;
    return {others.share(), times[high] / times[middle] - 1};
}

}  // namespace edgewise::measure
