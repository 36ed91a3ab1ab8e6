// SPDX-License-Identifier: MIT
//
// Which queries of a warm scene are the first of their pair: cold by nature, and left out of what is said of
// warm ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// One flag per query; all zero where every query is cold.
[[nodiscard]] inline std::vector<std::uint8_t> cold_starts(const scene::Workload& workload) {
    std::vector<std::uint8_t> cold(workload.queries.size(), 0), met(workload.pair_count, 0);
    for (std::size_t i = 0; workload.warm && i < cold.size(); ++i) {
        std::uint8_t& known = met[workload.queries[i].pair];
        cold[i] = !known;
        known = 1;
    }
    return cold;
}

/// Queries first .. end - 1 are of one class, with no cold start after the first.
[[nodiscard]] inline std::size_t end_of_stretch(const std::vector<std::uint8_t>& cold,
                                                std::span<const std::uint8_t> in_contact, std::size_t first) {
    std::size_t end = first + 1;
    while (end < in_contact.size() && in_contact[end] == in_contact[first] && !cold[end]) ++end;
    return end;
}

}  // namespace edgewise::bench
