// SPDX-License-Identifier: MIT
//
// Independent work on all processors. Nothing is timed meanwhile. Threads end with the work, since where few
// addresses are allowed (ulimit -v) what follows needs those of their stacks; those of oneTBB stay.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace edgewise::bench {

/// work(0) ... work(count - 1), in any order, several at a time. The first exception is passed on.
template <class Work>
void for_each_index(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
    };
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::future<void>> workers(std::min(count, processors));
    for (auto& worker : workers) worker = std::async(std::launch::async, run);
    for (auto& worker : workers) worker.wait();
    for (auto& worker : workers) worker.get();
}

}  // namespace edgewise::bench
