// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/calibration.hpp"

#include <algorithm>

#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::measure {

namespace {

/// The metric that counts the misses of a level. The last of the `levels` is the one that memory answers for.
const char* event_of(std::size_t level, std::size_t levels) {
    if (level == 0) return "l1d_fills";
    return level + 1 == levels ? "llc_misses" : "l2_demand_misses";
}

double modelled_misses(const CacheMachine& machine, std::size_t level, std::uint64_t bytes,
                       std::uint64_t loads) {
    RandomChase chase(bytes);
    CacheModel model(machine.caches);
    const auto touch = [&](std::uint64_t line) {
        model.access(line * RandomChase::line_bytes, 8, AccessKind::read);
    };
    for (std::uint64_t line = 0; line < chase.lines(); ++line) touch(line);
    chase.replay(2 * loads, touch);
    model.forget_counts();
    chase.replay(loads, touch);
    return static_cast<double>(model.counts(level).misses) / static_cast<double>(loads);
}

CalibrationRow calibrate(const CacheMachine& machine, std::size_t level, double times,
                         const CalibrationOptions& options, const Cpu& cpu) {
    CalibrationRow row;
    row.level = machine.caches.levels[level].name;
    row.times = times;
    row.bytes = static_cast<std::uint64_t>(times * static_cast<double>(machine.caches.bytes_of(level)));
    row.event = event_of(level, machine.caches.levels.size());
    row.modelled = modelled_misses(machine, level, row.bytes, options.loads);
    RandomChase chase(row.bytes);
    chase.run(2 * options.loads);
    const Stopwatch watch;
    chase.run(options.loads);
    row.ns = watch.elapsed_ns() / static_cast<double>(options.loads);
    const CountedPass counted = count_pass([&] { chase.run(options.loads); }, options.loads, cpu);
    const auto found = std::ranges::find(counted.records, row.event, &PassRecord::event);
    const bool is_known = found != counted.records.end();
    if (is_known) row.counted = found->value;
    row.reason = is_known ? found->refusal.reason : "no such event is known";
    return row;
}

}  // namespace

std::vector<CalibrationRow> calibrate_model(const CacheMachine& machine, const Cpu& cpu,
                                            const CalibrationOptions& options) {
    std::vector<CalibrationRow> rows;
    for (std::size_t level = 0; level < machine.caches.levels.size(); ++level) {
        const auto size = static_cast<double>(machine.caches.bytes_of(level));
        for (const double times : options.times) {
            if (times * size <= static_cast<double>(options.most_bytes))
                rows.push_back(calibrate(machine, level, times, options, cpu));
            else
                rows.push_back({.level = machine.caches.levels[level].name,
                                .times = times,
                                .bytes = static_cast<std::uint64_t>(times * size),
                                .reason = "more memory than is taken"});
        }
    }
    return rows;
}

namespace {

constexpr std::uint64_t line_bytes = 64, loads = 10000;  ///< of a pass: short enough not to be interrupted
constexpr int passes = 30;
constexpr std::uint64_t memory_over_last = 4;  ///< times the last level: rarely answered by it
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31;

/// Returns ns per load over this many bytes: the shortest pass after one that fills the caches.
double load_ns(std::uint64_t bytes) {
    RandomChase chase(std::clamp(bytes, line_bytes, most_bytes));
    chase.run(2 * chase.lines());
    double shortest = 0;
    for (int pass = 0; pass < passes; ++pass) {
        const Stopwatch watch;
        chase.run(loads);
        const double ns = watch.elapsed_ns() / static_cast<double>(loads);
        shortest = pass == 0 ? ns : std::min(shortest, ns);
    }
    return shortest;
}

}  // namespace

std::vector<double> latencies_beyond_first(const CacheMachine& host) {
    const double first = load_ns(host.caches.bytes_of(0) / 2);
    const auto beyond_first = [&](std::uint64_t bytes) { return std::max(0.0, load_ns(bytes) - first); };
    const std::size_t levels = host.caches.levels.size();
    std::vector<double> beyond;
    for (std::size_t i = 1; i < levels; ++i) beyond.push_back(beyond_first(host.caches.bytes_of(i) / 2));
    beyond.push_back(beyond_first(memory_over_last * host.caches.bytes_of(levels - 1)));
    return beyond;
}

}  // namespace edgewise::measure
