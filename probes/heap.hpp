// SPDX-License-Identifier: MIT
//
// Heap: what one table, the caches of all pairs and the broad phase's arrays take in jemalloc, each in an
// arena of its own. Slack is what size classes add to what was asked for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/bench/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

struct HeapStructure {
    std::string name;
    std::uint64_t requested = 0, size_classes = 0;
    std::uint64_t resident = 0;  ///< pages in memory, the arena's own books included
};

struct HeapUse {
    std::vector<HeapStructure> structures;
    std::string reason, remedy;  ///< why there are none
};

/// Each structure in a jemalloc arena of its own: one table of the first body, built anew; and blocks of the
/// sizes that the caches of a scene's pairs and the arrays of its broad phase have.
[[nodiscard]] HeapUse heap_of(const bench::ProbedCell& cell);

class heap final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "heap"; }
    [[nodiscard]] std::string_view summary() const override {
        return "one table, pair caches, broad phase in jemalloc: requested, size classes, slack, resident";
    }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        return {figures(heap_of(cell))};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const HeapUse& use) {
        if (use.structures.empty()) {
            return {store::no_figure(store::FigureName("heap.{structure}.requested_bytes").of("table"),
                                     use.reason.empty() ? "no structure was built in the heap" : use.reason,
                                     use.remedy.empty() ? "sweep the cell again" : use.remedy)};
        }
        std::vector<measure::Figure> all;
        for (const HeapStructure& structure : use.structures) {
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
