// SPDX-License-Identifier: MIT
//
// Counters: what the processor counted of a pass in the steady state, in small groups, a pass each, less what
// an empty batch costs; and what the kernel counted: page faults, context switches, migrations. What each
// event is and counts, on this machine, is in the build's record, as `edgewise machine` tells it.
#pragma once

#include "edgewise/measure/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class counters final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "counters"; }
    [[nodiscard]] std::string_view summary() const override {
        return "hardware counters a query, or why not; page faults, context switches, migrations a query";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        std::vector<measure::Figure> all;
        for (const measure::PassRecord& record : subject.counted)
            all.push_back(
                {record.event, record.value, record.unit, record.refusal.reason, record.refusal.remedy});
        if (all.empty())
            all.push_back(
                store::no_figure("counters.instructions", "no pass was counted", "sweep the cell again"));
        return all;
    }
};

}  // namespace edgewise::probes
