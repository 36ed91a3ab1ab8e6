// SPDX-License-Identifier: MIT
//
// How quiet the machine is: what other programs take of the processor that this thread runs on, and how much
// the times of a fixed piece of work vary. Both need no permission.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "edgewise/measure/process/thread_usage.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::measure {

/// The part of the elapsed time in which this thread did not run, though it had work: from 0 to 1.
class ShareOfOthers {
  public:
    void begin() {
        watch_.restart();
        began_ = thread_seconds();
    }
    void end() {
        elapsed_ += 1e-9 * watch_.elapsed_ns();
        ran_ += thread_seconds() - began_;
    }
    /// Over all times between begin() and end(); 0 if there were none.
    [[nodiscard]] double share() const { return elapsed_ > ran_ ? 1 - ran_ / elapsed_ : 0; }

  private:
    Stopwatch watch_;
    double began_ = 0, elapsed_ = 0, ran_ = 0;
};

struct Quietness {
    double others = 0;   ///< as ShareOfOthers
    double scatter = 0;  ///< 90th percentile of the times of a piece of work over their median, less 1

    [[nodiscard]] bool is_quiet() const { return others <= 0.02 && scatter <= 0.05; }
};

/// Multiplications that wait for each other: about a millisecond, the same number on every call.
[[nodiscard]] inline double time_of_fixed_work() {
    constexpr int multiplications = 1'000'000;
    const Stopwatch watch;
    std::uint64_t state = 1;
    for (int i = 0; i < multiplications; ++i) state = state * 6364136223846793005U + 1;
    volatile std::uint64_t kept = state;
    static_cast<void>(kept);
    return watch.elapsed_ns();
}

/// Works for a quarter of a second and looks at its times.
[[nodiscard]] inline Quietness look_at_quietness() {
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

/// A sweep whose thread lost more than this to others while it timed recommends nothing: intervals over
/// rounds do not show what is common to all rounds.
inline constexpr double most_of_others = 0.2;

}  // namespace edgewise::measure
