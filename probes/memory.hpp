// SPDX-License-Identifier: MIT
//
// Memory of a whole scene: what all its tables ask for, what that takes in the allocator, how many pages are
// really there, and how much of the tables ever stood (less than all in lazy ones).
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class memory final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "memory"; }
    [[nodiscard]] std::string_view summary() const override {
        return "bytes of all tables: asked for, taken by the allocator, resident; part ever materialised";
    }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        return {figures(cell.runner.memory())};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::MemoryUse& use) {
        const measure::Figure resident =
            use.resident ? store::figure("memory.resident_bytes", use.resident)
                         : store::no_figure("memory.resident_bytes",
                                            "this allocator's pages cannot be told from other memory",
                                            "allocator=arena");
        return {store::figure("memory.tables", static_cast<double>(use.tables)),
                store::figure("memory.requested_bytes", use.requested),
                store::figure("memory.taken_bytes", use.taken), resident,
                store::figure("memory.materialised", use.materialised)};
    }
};

}  // namespace edgewise::probes
