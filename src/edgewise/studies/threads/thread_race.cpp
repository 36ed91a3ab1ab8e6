// SPDX-License-Identifier: MIT
#include "edgewise/studies/threads/thread_race.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies {

CellCopy::CellCopy(const SingleCell& cell, const bench::RunnerOptions& options)
    : workload_(std::make_unique<scene::Workload>(cell.workload())),
      cell_(cell.type(), cell.algorithm(), options) {
    if (const std::string error = cell_.load(*workload_); !error.empty()) throw std::invalid_argument(error);
    pass_ = cell_.runner().prepared_frames();
}

TimedPass time_shared(bench::ThreadedPass& pass, int threads) {
    pass.set_back();
    pass.run(threads);
    pass.set_back();
    const measure::Stopwatch watch;
    pass.run(threads);
    const double ns = watch.elapsed_ns();
    return {ns, pass.sum()};
}

std::vector<TimedPass> time_apart(std::span<const CellCopy> copies) {
    std::vector<TimedPass> times(copies.size());
    std::atomic<std::size_t> ready = 0, done = 0;
    const auto race = [&](std::size_t i) {
        bench::ThreadedPass& pass = copies[i].pass();
        pass.set_back();
        pass.run(1);
        ++ready;
        while (ready < copies.size()) pass.run(1);
        pass.set_back();
        const measure::Stopwatch watch;
        pass.run(1);
        times[i].ns = watch.elapsed_ns();
        ++done;
        times[i].sum = pass.sum();
        while (done < copies.size()) pass.run(1);
    };
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < copies.size(); ++i) threads.emplace_back(race, i);
    }
    return times;
}

}  // namespace edgewise::studies
