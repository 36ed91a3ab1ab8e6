// SPDX-License-Identifier: MIT
//
// What the operating system did to this thread during a stretch of work: page faults, context switches, moves
// to another processor. Wherever the processor has no counters, these still are there. Here 0 is a value: it
// is what a steady pass should show.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/counters/perf_event.hpp"
#include "edgewise/measure/machine/cpu.hpp"
#include "edgewise/measure/process/thread_usage.hpp"

namespace edgewise::measure {

class SoftwareWatch {
  public:
    explicit SoftwareWatch(const Cpu& cpu);

    void start();

    /// minor_faults, major_faults, context_switches, cpu_migrations since start(); values per query.
    [[nodiscard]] std::vector<PassRecord> stop(std::size_t queries);

  private:
    PassRecord migrations(std::size_t queries);

    Cpu cpu_;
    PerfEvent migrations_;
    ThreadUsage before_;
};

/// Calls `pass` once.
[[nodiscard]] std::vector<PassRecord> count_software(const std::function<void()>& pass, std::size_t queries,
                                                     const Cpu& cpu);

}  // namespace edgewise::measure
