// SPDX-License-Identifier: MIT
//
// Where in a trace's addresses things lie: the tables from 0 on, then, from a page's start each, the caches
// of pairs and the arrays of the broad phase.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "edgewise/algorithms/sweep_and_prune.hpp"

namespace edgewise::bench {

struct TracePlaces {
    const void* base = nullptr;  ///< of the tables
    std::uint64_t pair_caches = 0;
    std::uint32_t pair_bytes = 0;  ///< of one
    std::array<std::uint64_t, broad_phase_arrays> broad_phase{};

    TracePlaces() = default;
    /// table_bytes: from the base to the last table's end. Each pair has a cache of bytes_a_pair bytes.
    TracePlaces(const void* tables, std::uint64_t table_bytes, std::uint32_t bytes_a_pair,
                std::uint64_t pair_count, std::uint64_t body_count)
        : base(tables), pair_caches(page_after(table_bytes)), pair_bytes(bytes_a_pair) {
        std::uint64_t at = pair_caches + pair_count * bytes_a_pair;
        for (std::size_t i = 0; i < broad_phase_arrays; ++i) {
            broad_phase[i] = page_after(at);
            at = broad_phase[i] + body_count * element_bytes[i];
        }
    }

    /// Element sizes of the broad phase's arrays: boxes, three orders, pairs.
    static constexpr std::array<std::uint32_t, broad_phase_arrays> element_bytes = {
        sizeof(Aabb), sizeof(std::uint32_t), sizeof(std::uint32_t), sizeof(std::uint32_t), sizeof(BodyPair)};

    /// Start of the first page after the first `at` bytes.
    [[nodiscard]] static std::uint64_t page_after(std::uint64_t at) { return (at + page - 1) / page * page; }

  private:
    static constexpr std::uint64_t page = 4096;
};

}  // namespace edgewise::bench
