// SPDX-License-Identifier: MIT
//
// The interface of a probe: it is given a cell, measures, and names the figures it makes of that. A probe is
// one file and one line in probes/CMakeLists.txt.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/expected.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::measure {
struct SceneTrace;
}

namespace edgewise::bench {

/// Caches that a sweep wants modelled of a cell: on which machines, over how many queries and steps.
struct CacheOrder {
    std::span<const measure::MachineChoice> machines = {};  ///< empty: no caches are modelled
    std::size_t queries = 0;                                ///< number of traced queries that count; 0: all
    std::size_t steps = 0;  ///< and in a scene in time order at least this number of whole steps

    /// A number that is another one for other machines, or another number of queries or steps; whole, and
    /// exact as a figure.
    [[nodiscard]] double identity() const;
};

/// What was counted over all answers of a cell.
struct AnswerCounts {
    std::uint64_t queries = 0, steps = 0, fallbacks = 0, cycles = 0;
    int max_steps = 0;
    std::uint64_t refinements = 0, escapes = 0;
    std::uint64_t warm = 0, unchanged = 0;  ///< queries that start warm; those that end where they started
    std::uint64_t told = 0;                 ///< warm ones that the pair's bounds answered, in no step
    std::uint64_t warm_steps = 0;           ///< of the steps, those of queries that started warm
    int max_warm_steps = 0, max_cold_steps = 0;
    bool follows_pairs = false;  ///< else every query starts cold
};

/// A cell at work: the tables are loaded and the answers checked. Whatever else a probe wants to know it
/// finds out itself, by asking the runner.
struct ProbedCell {
    const TableType& type;
    const AlgorithmInfo& algorithm;
    const Runner& runner;  ///< with the workload loaded
    const scene::Workload& workload;
    bool plain = true;                                    ///< without further axes
    Needs needs = Needs::witnesses;                       ///< what was asked of every answer
    bool verified = true;                                 ///< else a checked answer is wrong
    std::span<const std::size_t> checked_positions = {};  ///< of the queries that were checked
    std::span<const truth::CheckedAnswer> checked = {};   ///< in that order
    AnswerCounts counts = {};                             ///< of all answers
    std::span<const measure::Round> rounds = {};          ///< timed so far
    CacheOrder caches = {};                               ///< what is to be modelled
    /// Made by the first probe that asks for it (trace/trace_scene.hpp).
    mutable std::shared_ptr<const measure::SceneTrace> trace = {};
};

struct Findings {
    std::vector<measure::Figure> figures;
    /// Sum of a pass over the queries by the probe: the cell fails if it gave other answers.
    std::optional<PassSum> passed = {};
};

struct Probe {
    std::string_view name, summary;
    /// Measures the figures: each is a number, or none with a reason and a remedy.
    Findings (*measure)(const ProbedCell& cell);
    /// True if it may measure while other cells are measured: none of its figures is a time. Runs first.
    bool beside_others;
    /// True if it measures other libraries too: it uses only answers, rounds and sizes.
    bool of_peers;
};

/// The probe of a type with a summary, measure and, where they are true, beside_others and of_peers.
template <class Measuring>
constexpr Probe probe_of(std::string_view name) {
    constexpr bool beside_others = requires { Measuring::beside_others; };
    constexpr bool of_peers = requires { Measuring::of_peers; };
    return {name, Measuring::summary, Measuring::measure, beside_others, of_peers};
}

/// Returns every probe of this program, in the order of the manifest probes/CMakeLists.txt.
[[nodiscard]] std::span<const Probe> registered_probes();

}  // namespace edgewise::bench
