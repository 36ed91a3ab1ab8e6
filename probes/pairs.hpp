// SPDX-License-Identifier: MIT
//
// Cost of keeping a pair: an engine that queries pairs as they come finds each pair's cache in a hash map,
// and makes its entry at the first query, as the libraries of the paper's time did. Edgewise's own loops find
// it by its number. Measured by itself, with entries of this cell's size, so that a time per query can be
// read with and without: std::unordered_map, a node for each entry, as theirs had.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class pairs {
  public:
    static constexpr std::string_view summary =
        "median time to make a pair's entry in a hash map, and to find it";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        const std::size_t count = std::clamp<std::size_t>(cell.workload.queries.size(), 1, most_pairs);
        const Times times = timed(cell.runner.pair_bytes(), keys_of(count));
        const auto figure = [&](const store::FigureName& name, const std::vector<double>& of) {
            return store::figure(name, measure::median(of), "no pair was made", "run the sweep again");
        };
        return {{figure("pairs.creation_ns", times.creation_ns), figure("pairs.find_ns", times.find_ns)}};
    }

    struct Times {
        std::vector<double> creation_ns, find_ns;  ///< per pair, of each repetition
        std::size_t found = 0;                     ///< by all repetitions
    };

    /// Times a map with entries of `bytes` bytes, rounded up to the next power of two.
    [[nodiscard]] static Times timed(std::size_t bytes, const std::vector<std::uint64_t>& keys) {
        if (bytes <= 8) return timed_of<8>(keys);
        if (bytes <= 16) return timed_of<16>(keys);
        if (bytes <= 32) return timed_of<32>(keys);
        if (bytes <= 64) return timed_of<64>(keys);
        return timed_of<128>(keys);
    }

    /// Keys in no order, as two bodies' addresses would give them (Knuth's multiplicative hashing).
    [[nodiscard]] static std::vector<std::uint64_t> keys_of(std::size_t count) {
        constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;
        std::vector<std::uint64_t> keys;
        for (std::size_t i = 1; i <= count; ++i) keys.push_back(i * golden_ratio);
        return keys;
    }

  private:
    static constexpr std::size_t most_pairs = 2000;
    static constexpr int repetitions = 9;

    template <std::size_t Bytes>
    [[nodiscard]] static Times timed_of(const std::vector<std::uint64_t>& keys) {
        const auto count = static_cast<double>(keys.size());
        Times times;
        for (int i = 0; i < repetitions; ++i) {
            std::unordered_map<std::uint64_t, std::array<std::byte, Bytes>> entries;
            const measure::Stopwatch creation;
            for (const std::uint64_t key : keys) entries[key] = {};
            times.creation_ns.push_back(creation.elapsed_ns() / count);
            const measure::Stopwatch find;
            for (const std::uint64_t key : keys) times.found += entries.find(key) != entries.end();
            times.find_ns.push_back(find.elapsed_ns() / count);
        }
        return times;
    }
};

}  // namespace edgewise::probes
