// SPDX-License-Identifier: MIT
//
// Heap: what one table, the caches of all pairs and the broad phase's arrays take in jemalloc, each in an
// arena of its own. Slack is what size classes add to what was asked for.
#pragma once

#include "edgewise/measure/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class heap final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "heap"; }
    [[nodiscard]] std::string_view summary() const override {
        return "one table, pair caches, broad phase in jemalloc: requested, size classes, slack, resident";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::HeapUse& use = subject.heap;
        if (use.structures.empty()) {
            return {store::no_figure(store::FigureName("heap.{structure}.requested_bytes").of("table"),
                                     use.reason.empty() ? "no structure was built in the heap" : use.reason,
                                     use.remedy.empty() ? "sweep the cell again" : use.remedy)};
        }
        std::vector<measure::Figure> all;
        for (const measure::HeapStructure& structure : use.structures) {
            const auto requested = static_cast<double>(structure.requested),
                       classes = static_cast<double>(structure.size_classes);
            const auto add = [&](const store::FigureName& name, double bytes) {
                all.push_back(store::figure(name.of(structure.name), bytes));
            };
            add("heap.{structure}.requested_bytes", requested);
            add("heap.{structure}.size_class_bytes", classes);
            add("heap.{structure}.slack_bytes", classes - requested);
            add("heap.{structure}.resident_bytes", static_cast<double>(structure.resident));
        }
        return all;
    }
};

}  // namespace edgewise::probes
