// SPDX-License-Identifier: MIT
//
// Memory of a whole scene: what all its tables ask for, what that takes in the allocator, how many pages are
// really there, and how much of the tables ever stood (less than all in lazy ones).
#pragma once

#include "edgewise/measure/probe.hpp"

namespace edgewise::probes {

class memory final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "memory"; }
    [[nodiscard]] std::string_view summary() const override {
        return "bytes of all tables: asked for, taken by the allocator, resident; part ever materialised";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::MemoryUse& use = subject.memory;
        const measure::Figure resident =
            use.resident ? measure::Figure{"resident_bytes", use.resident, "B"}
                         : measure::Figure{"resident_bytes", std::nullopt, "B",
                                           "this allocator's pages cannot be told from other memory",
                                           "allocator=arena"};
        return {{"tables", static_cast<double>(use.tables), "tables"},
                {"requested_bytes", use.requested, "B"},
                {"taken_bytes", use.taken, "B"},
                resident,
                {"materialised", use.materialised, "1"}};
    }
};

}  // namespace edgewise::probes
