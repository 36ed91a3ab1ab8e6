// SPDX-License-Identifier: MIT
//
// Counters: processor counts of a pass in the steady state, in small groups, a pass each, less those of
// an empty batch; and kernel counts: page faults, context switches, migrations. The build's record says
// what each event is and counts on this machine, as `edgewise machine` shows it.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

struct counters {
    static constexpr std::string_view summary =
        "hardware counters per query, or why not; page faults, context switches, migrations per query";

    /// Measures in the steady state: all tables and pairs were used before.
    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        if (!cell.verified) return {figures({})};
        static const measure::Cpu cpu = measure::read_machine().cpu;
        const std::function<bench::PassSum()> pass = cell.runner.prepared_pass();
        bench::PassSum last = pass();
        const std::function<void()> again = [&] { last = pass(); };
        const std::size_t queries = cell.workload.queries.size();
        std::vector<measure::PassRecord> counted = measure::count_software(again, queries, cpu);
        const measure::CountedPass hardware = measure::count_pass(again, queries, cpu);
        counted.insert(counted.end(), hardware.records.begin(), hardware.records.end());
        return {figures(counted), last};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(std::span<const measure::PassRecord> counted) {
        std::vector<measure::Figure> all;
        for (const measure::PassRecord& record : counted)
            all.push_back(
                {record.event, record.value, record.unit, record.refusal.reason, record.refusal.remedy});
        if (all.empty())
            all.push_back(
                store::no_figure("counters.instructions", "no pass was counted", "sweep the cell again"));
        return all;
    }
};

}  // namespace edgewise::probes
