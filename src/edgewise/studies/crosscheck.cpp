// SPDX-License-Identifier: MIT
#include "edgewise/studies/crosscheck.hpp"

#include <fmt/format.h>
#include <linux/perf_event.h>

#include <algorithm>
#include <functional>
#include <sstream>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"
#include "edgewise/measure/counters/events.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::studies {

namespace {

using Count = measure::Expected<double>;
using Text = measure::Expected<std::string>;

class ModelListener final : public measure::TraceListener {
  public:
    ModelListener(const measure::CacheGeometry& geometry, bool with_poses)
        : model_(geometry), with_poses_(with_poses) {}

    /// A pass has no broad phase, and reads and writes a pair's cache word by word.
    void on_access(const measure::TracedAccess& access) override {
        if (access.step == static_cast<std::uint8_t>(bench::TraceStep::broad_phase)) return;
        const std::uint32_t piece = access.side == measure::TraceSide::scene ? 8 : access.bytes;
        for (std::uint32_t at = 0; at < access.bytes; at += piece)
            model_.access(access.address + at, std::min(piece, access.bytes - at), access.kind);
    }
    void on_query_end(bool /*counts*/) override {
        for (std::uint64_t word = 0; with_poses_ && word < sizeof(scene::Query); word += 8)
            model_.access(queries_at + query_ * sizeof(scene::Query) + word, 8, measure::AccessKind::read);
        ++query_;
    }

    void start_pass() {
        model_.forget_counts();
        query_ = 0;
    }
    [[nodiscard]] const measure::CacheModel& model() const { return model_; }

  private:
    static constexpr std::uint64_t queries_at = std::uint64_t{1} << 40;  ///< away from all tables

    measure::CacheModel model_;
    bool with_poses_;
    std::uint64_t query_ = 0;
};

/// Returns the name that perf takes for an event: its raw code, or perf's own name if it has one.
std::optional<std::string> perf_name(const measure::ChosenEvent& event) {
    if (event.code.type == PERF_TYPE_RAW) return fmt::format("r{:x}", event.code.config);
    if (event.code.type != PERF_TYPE_HARDWARE) return std::nullopt;
    if (event.code.config == PERF_COUNT_HW_INSTRUCTIONS) return "instructions";
    if (event.code.config == PERF_COUNT_HW_CACHE_MISSES) return "cache-misses";
    return std::nullopt;
}

/// Reads the count of one line of `perf stat -x,`: value, unit, event, time, part of the time in per cent.
Count perf_count(const std::string& output, const std::string& event) {
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string value, unit, name, time, part;
        for (std::string* word : {&value, &unit, &name, &time, &part}) std::getline(words, *word, ',');
        if (name.substr(0, name.find(':')) != event) continue;
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        if (end == value.c_str() || *end != '\0') return Count::none("perf says: " + value);
        if (std::strtod(part.c_str(), nullptr) < 100)
            return Count::none("it shared a counter: perf's count is a guess");
        return {number};
    }
    return Count::none("perf said nothing of it");
}

Text perf_output(const CellChoice& choice, const std::string& program, const std::string& event, int passes) {
    std::vector<std::string> command = {"perf", "stat", "-x,", "-e", event + ":u"};
    const auto words = pass_command(choice, program, passes);
    command.insert(command.end(), words.begin(), words.end());
    const auto outcome = measure::run_program(command);
    if (!outcome.value) return Text::none(outcome.reason + "; install linux-perf");
    if (outcome.value->exit_code != 0) return Text::none("perf failed: " + outcome.value->err.substr(0, 200));
    return {outcome.value->err};
}

Count count_by_perf(const CellChoice& choice, const std::string& program, const measure::ChosenEvent& event) {
    constexpr int passes = 20;
    if (!event.refusal.reason.empty()) return Count::none(event.refusal.reason);
    const std::optional<std::string> name = perf_name(event);
    if (!name) return Count::none("perf has no plain name for it");
    double counts[2] = {};
    for (int k = 0; k < 2; ++k) {
        const Text output = perf_output(choice, program, *name, 1 + k * passes);
        if (!output.value) return Count::none(output.reason);
        const Count count = perf_count(*output.value, *name);
        if (!count.value) return count;
        counts[k] = *count.value;
    }
    if (counts[1] <= counts[0]) return Count::none("lost in what else the program does");
    return {(counts[1] - counts[0]) / passes};
}

using Trace = std::vector<measure::TracedAccess>;

struct Recorder final : measure::TraceListener {
    void on_access(const measure::TracedAccess& access) override { trace.push_back(access); }
    Trace trace;
};

/// Returns aligned reads of 8 bytes at random addresses below `bytes`.
Trace scattered(std::uint64_t bytes) {
    scene::Rng rng(1);
    Trace trace(500'000, {0, 8, measure::AccessKind::read, 0, 0, measure::TraceSide::table_a});
    for (measure::TracedAccess& access : trace) access.address = rng.below(bytes / 8) * 8;
    return trace;
}

/// Runs `pass` once, then times it.
ModelSpeed timed(const std::string& what, const std::string& name, const Trace& trace, int repetitions,
                 const std::function<void(const Trace&)>& pass) {
    pass(trace);
    std::vector<double> per_second;
    for (int i = 0; i < repetitions; ++i) {
        const measure::Stopwatch watch;
        pass(trace);
        per_second.push_back(static_cast<double>(trace.size()) / (watch.elapsed_ns() * 1e-9));
    }
    return {what, name, trace.size(), measure::median(per_second).value_or(0)};
}

void add_speeds(const std::string& name, const Trace& trace, int repetitions,
                const measure::CacheMachine& machine, std::vector<ModelSpeed>& speeds) {
    measure::CacheModel model(machine.caches);
    speeds.push_back(timed("cache model, three levels", name, trace, repetitions, [&](const Trace& all) {
        for (const measure::TracedAccess& access : all)
            model.access(access.address, access.bytes, access.kind);
    }));
    measure::ReuseDistance lines;
    speeds.push_back(timed("reuse distance, lines", name, trace, repetitions, [&](const Trace& all) {
        for (const measure::TracedAccess& access : all) lines.use(access.address / 64);
    }));
    measure::SceneCaches caches({&machine, 1}, bench::field_names().size(), bench::step_names().size());
    speeds.push_back(
        timed("one machine with TLBs, causes and reuse", name, trace, repetitions, [&](const Trace& all) {
            for (const measure::TracedAccess& access : all) caches.on_access(access);
        }));
}

}  // namespace

measure::CallgrindCounts model_pass(const SingleCell& cell, const measure::CacheGeometry& geometry,
                                    bool with_poses) {
    ModelListener listener(geometry, with_poses);
    const bench::TraceExtent all = bench::TraceExtent::everything();
    cell.runner().trace(all, listener);
    listener.start_pass();
    cell.runner().trace(all, listener);
    const auto count = [](std::uint64_t n) { return static_cast<double>(n); };
    return {0, count(listener.model().counts(0).accesses), count(listener.model().counts(0).misses),
            count(listener.model().counts(1).misses)};
}

measure::Expected<measure::CacheGeometry> without_ways_of_the_stack(measure::CacheGeometry geometry) {
    std::uint32_t& ways = geometry.levels[0].ways;
    if (ways < 2) return measure::Expected<measure::CacheGeometry>::none("the first level has one way");
    ways -= ways > 2 ? 2 : 1;
    if (geometry.levels.back().ways > 1) --geometry.levels.back().ways;
    return {std::move(geometry)};
}

std::vector<PerfCount> perf_pass(const CellChoice& choice, const std::string& program,
                                 const measure::Cpu& cpu) {
    std::vector<PerfCount> counts;
    for (const measure::ChosenEvent& event : measure::chosen_events(cpu)) {
        const bool wanted = event.event == "instructions" || event.event == "l1d_fills" ||
                            event.event == "l2_demand_misses" || event.event == "llc_misses";
        if (wanted)
            counts.push_back(
                {event.event, event.encoding, event.level, count_by_perf(choice, program, event)});
    }
    return counts;
}

std::vector<ModelSpeed> model_speeds(const SingleCell& cell, int repetitions) {
    const measure::CacheMachine machine = measure::described_machines({"zen5"}).front();
    Recorder own;
    cell.runner().trace(bench::TraceExtent::everything(), own);
    std::vector<ModelSpeed> speeds;
    add_speeds("the cell's own", own.trace, repetitions, machine, speeds);
    add_speeds("random in 16 KiB", scattered(1 << 14), repetitions, machine, speeds);
    add_speeds("random in 64 MiB", scattered(1 << 26), repetitions, machine, speeds);
    return speeds;
}

}  // namespace edgewise::studies
