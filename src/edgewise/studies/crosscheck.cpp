// SPDX-License-Identifier: MIT
#include "edgewise/studies/crosscheck.hpp"

#include <fmt/format.h>
#include <linux/perf_event.h>

#include <algorithm>
#include <sstream>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/counters/events.hpp"
#include "edgewise/measure/process/child_process.hpp"

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

}  // namespace edgewise::studies
