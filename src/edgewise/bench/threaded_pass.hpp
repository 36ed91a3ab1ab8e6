// SPDX-License-Identifier: MIT
//
// A pass over a workload's queries as an engine with threads makes it: frame after frame, each frame one
// batch that the threads share.
#pragma once

#include <cstddef>

namespace edgewise::bench {

class ThreadedPass {
  public:
    ThreadedPass() = default;
    ThreadedPass(const ThreadedPass&) = delete;
    ThreadedPass& operator=(const ThreadedPass&) = delete;
    virtual ~ThreadedPass() = default;

    /// Pairs know nothing any more, as before the first frame.
    virtual void set_back() = 0;

    /// Answers every query once, in at most `threads` threads including the caller's; returns after the last.
    virtual void run(int threads) = 0;

    /// Sum of the last run's distances in the order of the workload's queries, in the runner's unit: the bits
    /// of a RangePass over all of them.
    [[nodiscard]] virtual double sum() const = 0;

    /// Batches of a run.
    [[nodiscard]] virtual std::size_t frames() const = 0;
};

}  // namespace edgewise::bench
