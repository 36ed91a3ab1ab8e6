// SPDX-License-Identifier: MIT
#include "edgewise/studies/model_speed.hpp"

#include <algorithm>
#include <functional>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::studies {

namespace {

using Trace = std::vector<measure::TracedAccess>;

class Recorder final : public measure::TraceListener {
  public:
    void on_access(const measure::TracedAccess& access) override { trace_.push_back(access); }
    void on_query_end(bool /*counts*/) override {}

    [[nodiscard]] Trace take() { return std::move(trace_); }

  private:
    Trace trace_;
};

Trace trace_of(const SingleCell& cell) {
    Recorder recorder;
    cell.runner().trace(bench::TraceExtent::everything(), recorder);
    return recorder.take();
}

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

std::vector<ModelSpeed> model_speeds(const SingleCell& cell, int repetitions) {
    const std::string names[] = {"zen5"};
    const measure::MachineChoice machine = measure::choose_machines(names).front();
    std::vector<ModelSpeed> speeds;
    add_speeds("the cell's own", trace_of(cell), repetitions, *machine.machine.value, speeds);
    add_speeds("random in 16 KiB", scattered(1 << 14), repetitions, *machine.machine.value, speeds);
    add_speeds("random in 64 MiB", scattered(1 << 26), repetitions, *machine.machine.value, speeds);
    return speeds;
}

}  // namespace edgewise::studies
