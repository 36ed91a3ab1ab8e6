// SPDX-License-Identifier: MIT
//
// The clock of every time: std::chrono::steady_clock, which never runs backwards and counts in nanoseconds.
// Reading it costs about as much as a short query, so batches are timed and calibrate() is subtracted once
// per batch.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "edgewise/measure/statistics.hpp"

namespace edgewise::measure {

class Stopwatch {
  public:
    using Clock = std::chrono::steady_clock;
    static_assert(Clock::is_steady);

    Stopwatch() : start_(Clock::now()) {}

    void restart() { start_ = Clock::now(); }

    /// Since construction or the last restart; runs on.
    [[nodiscard]] double elapsed_ns() const {
        return std::chrono::duration<double, std::nano>(Clock::now() - start_).count();
    }

  private:
    Clock::time_point start_;
};

/// Reading of a stopwatch, in ns, when nothing was done between start and stop: the median of many, since
/// single readings are spoilt by interrupts. Measured where and when it is used: it changes with the
/// machine's clock source.
[[nodiscard]] inline double calibrate(std::size_t readings = 10'001) {
    std::vector<double> costs(readings == 0 ? 1 : readings);
    Stopwatch watch;
    for (double& cost : costs) {
        watch.restart();
        cost = watch.elapsed_ns();
    }
    return median(costs).value_or(0);
}

}  // namespace edgewise::measure
