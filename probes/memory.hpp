// SPDX-License-Identifier: MIT
//
// Memory of a whole scene: what all its tables ask for, what that takes in the allocator, how many pages are
// really there, and how much of the tables was ever made (less than all in lazy ones).
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

struct memory {
    static constexpr std::string_view summary =
        "bytes of all tables: asked for, taken by the allocator, resident; part ever materialised";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(cell.runner.memory())};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const bench::MemoryUse& use) {
        return {store::figure("memory.tables", use.tables),
                store::figure("memory.requested_bytes", use.requested),
                store::figure("memory.taken_bytes", use.taken),
                store::figure("memory.resident_bytes", use.resident,
                              "this allocator's pages cannot be distinguished from other memory",
                              "allocator=arena"),
                store::figure("memory.materialised", use.materialised)};
    }
};

}  // namespace edgewise::probes
