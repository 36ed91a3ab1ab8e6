// SPDX-License-Identifier: MIT
//
// Possible causes of figure 8: every combination of the conditions that the paper leaves open is scored by
// the four facts that the figure states. Demands are traced once (below). The rest is arithmetic,
// so it is the same on every machine, except the cost of building
// a table, which is measured here.
//
// The four facts that figure 8 states (section 4), each a number and a rule. The time axes of figures 7 and 8
// have marks at their ends only, 1e-4 s and 1.2e-3 s: a maximum is known to a factor of two at best.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/runner_options.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::studies::thrash {

// Memory demand of one scene's queries for any memory size: a trace in time order through reuse distances
// (reuse_distance.hpp), of lines of 32 bytes as the processors of the paper's time had them, and of pages of
// 4 KiB. Everything counts that a step reads and writes: tables, the caches of pairs, the broad phase's
// arrays. Some steps fill the memory, those after them count.

inline constexpr std::uint64_t line_bytes = 32, page_bytes = 4096;

/// Bodies of one shape that tumble, as in the paper's figures 4 and 6 to 8.
struct Scene {
    std::string shape;
    std::size_t bodies = 0;
    double rotation_step = 0;       ///< rad
    double step_in_dimensions = 0;  ///< way of a step over the smallest dimension
    std::size_t steps = 0;
    std::uint64_t seed = 1;
};

/// Throws std::invalid_argument if the scene cannot be made.
[[nodiscard]] scene::Workload workload_of(const Scene& scene);

/// Sizes at which a demand is known, in ascending order.
struct MemorySizes {
    std::vector<std::uint64_t> lines, pages;
};

/// Numbers per query of the counted steps, with the first queries of pairs.
struct MemoryDemand {
    std::uint64_t queries = 0, steps = 0;
    double reads = 0;                              ///< of fields and of pairs' caches: the processor's work
    std::vector<double> line_misses, page_misses;  ///< by size, as MemorySizes has them; LRU; no first uses
    double pages = 0;   ///< distinct in the whole run, of everything; not per query
    double cycles = 0;  ///< that V-Clip ran into, of all queries traced; a count
    double lines_of_a_step = 0, pages_of_a_step = 0;  ///< distinct ones of a step, summed, per query
    double table_bytes = 0;                           ///< of one body's table
    double tables = 0;                                ///< number of tables
    std::string reason;                               ///< why there is none of this
};

/// `filling`: number of steps before the counted steps.
[[nodiscard]] MemoryDemand trace_demand(const bench::TableType& type, const std::string& algorithm,
                                        const scene::Workload& workload, bench::Sharing sharing,
                                        const MemorySizes& sizes, std::size_t filling);

// Time of a query on a processor of the paper's time with too little memory:
//
//     t = reads x k + sum over levels of misses x latency + TLB misses x walk + faults x c
//
// k is the processor's time for each read of a field with all data in its first cache: one number per machine
// and time step, fitted so that the tops of figures 4, 6 and 7 (without thrashing, says the paper) are met on
// average. Reads measure the processor's work: unlike instructions, they can be counted in every cell. The
// caches are fully associative LRU: exact for any size, with slightly fewer misses than real ones.

/// One of measure/machines with lines of 32 bytes and two levels.
class OldMachine {
  public:
    /// Throws std::invalid_argument if the machine has other lines or levels, or no known latencies.
    explicit OldMachine(const measure::CacheMachine& machine);

    [[nodiscard]] const std::string& name() const { return machine_->name; }
    [[nodiscard]] double ns_of_cycles(double cycles) const { return cycles * 1000 / machine_->clock_mhz; }
    [[nodiscard]] std::uint64_t lines(std::size_t level) const {
        return machine_->caches.bytes_of(level) / line_bytes;
    }
    [[nodiscard]] std::uint64_t tlb_pages() const { return machine_->tlbs.bytes_of(0) / page_bytes; }

    /// Return the latency of an answer, minus the latency of the first level.
    [[nodiscard]] double second_level_ns() const {
        return ns_of_cycles(machine_->origins[1].latency_cycles - machine_->origins[0].latency_cycles);
    }
    [[nodiscard]] double memory_ns() const {
        return ns_of_cycles(machine_->memory.latency_cycles - machine_->origins[0].latency_cycles);
    }
    /// Returns the time of a page walk: it reads two tables (32-bit processors), assumed in the second level.
    [[nodiscard]] double walk_ns() const { return 2 * second_level_ns(); }

    /// Returns the time of misses: `first` and `second` of the two levels, `tlb` of the TLB.
    [[nodiscard]] double memory_time_ns(double first, double second, double tlb) const {
        return (first - second) * second_level_ns() + second * memory_ns() + tlb * walk_ns();
    }

  private:
    const measure::CacheMachine* machine_;
};

/// Returns the factorial's machines, from measure/machines: older than the paper, written in 2000 or 2001.
[[nodiscard]] std::vector<OldMachine> old_machines();

/// Returns the sizes of the machines' caches and TLBs, and the sizes in `memories` (bytes).
[[nodiscard]] MemorySizes sizes_for(const std::vector<OldMachine>& machines,
                                    const std::vector<std::uint64_t>& memories);

/// Returns the misses of a demand at one of its sizes.
[[nodiscard]] double misses_at(const std::vector<std::uint64_t>& sizes, const std::vector<double>& misses,
                               std::uint64_t size);

/// Returns the time of a query's misses in caches and TLB.
[[nodiscard]] double cache_ns(const OldMachine& machine, const MemorySizes& sizes,
                              const MemoryDemand& demand);

/// The end of a figure's time axis, and the reads and memory time of the slower algorithm there.
struct CalibrationPoint {
    int figure = 0;
    double top_ns = 0;
    double reads = 0, memory_ns = 0;

    [[nodiscard]] double model_ns(double ns_per_read) const { return reads * ns_per_read + memory_ns; }
};

/// Returns k, for which the mean of log(model over top) is 0; 0 if memory alone takes longer.
[[nodiscard]] double ns_per_read(const std::vector<CalibrationPoint>& points);

/// The axis of speed of figures 7 and 8, rad per second.
inline constexpr std::array<double, 7> speeds = {1, 2, 3, 4, 5, 6, 7};

/// ns per query at each of the speeds.
using SpeedCurve = std::array<double, speeds.size()>;

struct Figure8 {
    SpeedCurve vclip_8, vclip_38, vclip_386, gjk_8, gjk_38, gjk_386;
};

enum class Fact : std::uint8_t { rises, takes_as_long, spares_gjk, erratic };
inline constexpr std::array<std::string_view, 4> fact_names = {"rises", "takes_as_long", "spares_gjk",
                                                               "erratic"};

inline constexpr double least_rise = 6, most_rise = 24;             ///< half and double of 12
inline constexpr double least_top_ns = 0.6e6, most_top_ns = 1.2e6;  ///< of an axis that ends at 1.2e-3 s
inline constexpr double most_gjk_rise = 2;
inline constexpr double least_fall = 1.2;  ///< as the claim vclip_erratic_at_386 has it

struct FactScore {
    double rise = 0;             ///< V-Clip's longest at 386 vertices over its longest at 38
    double top_ns = 0;           ///< V-Clip's longest at 386
    double gjk_rise = 0;         ///< GJK's longest, likewise
    double gjk_rise_from_8 = 0;  ///< shown, not scored
    double fall = 0;             ///< the largest of V-Clip at 386 from one speed to a faster one, as a ratio
    double gjk_fall = 0;
    std::array<bool, 4> holds{};

    [[nodiscard]] int count() const { return holds[0] + holds[1] + holds[2] + holds[3]; }
    /// Bit i: fact i holds.
    [[nodiscard]] unsigned mask() const {
        return holds[0] * 1U + holds[1] * 2U + holds[2] * 4U + holds[3] * 8U;
    }
};

/// Returns the largest ratio of a time to the time at a faster speed; 1 or less if the time never falls.
[[nodiscard]] double largest_fall(const SpeedCurve& curve);

[[nodiscard]] FactScore score(const Figure8& figure);

/// Work that happens besides the queries.
enum class Mechanism : std::uint8_t {
    queries_alone,
    whole_table_transform,  ///< every body's V-Clip table is brought to world space in every step
    builds,                 ///< `intensity`: tables built per query, by both algorithms
    builds_of_vclip,        ///< `intensity`: tables built per query, by V-Clip alone
    capped_cycles,          ///< `intensity`: feature steps per query lost to cycles at 386 vertices
    first_touches           ///< every page faults once in the 30 000 iterations of a point
};
inline constexpr std::string_view mechanism_names[] = {
    "queries_alone", "whole_table_transform", "builds", "builds_of_vclip", "capped_cycles", "first_touches"};

/// One combination of levels, except algorithm, size and speed, which are summed over.
struct Setting {
    Mechanism mechanism = Mechanism::queries_alone;
    double intensity = 0;
    std::string table;
    bool shared = false;
    double time_step = 0;  ///< s
    std::size_t bodies = 0;
    std::uint64_t memory_bytes = 0;
    double fault_ns = 0;
    std::size_t machine = 0;  ///< of old_machines()

    [[nodiscard]] bool operator==(const Setting&) const = default;
};

struct Outcome {
    Setting setting;
    Figure8 figure;
    FactScore score;
};

/// The levels of every factor. The defaults are the study's; tests take fewer.
struct Levels {
    std::vector<std::string> tables = {"aos_f64", "linked_f64"};
    std::vector<bool> shared = {false, true};
    std::vector<double> time_steps = {1.0 / 60, 0.5};
    std::vector<std::size_t> bodies = {100, 200, 300, 600};
    std::vector<std::uint64_t> memories_mib = {16, 20, 24,  28,  32,  40,  48,  56, 64,
                                               80, 96, 112, 128, 160, 192, 224, 256};
    std::vector<double> fault_costs_ns = {1e4, 1e5, 4e6, 1e7};
    std::vector<std::pair<Mechanism, double>> mechanisms = {
        {Mechanism::queries_alone, 0},      {Mechanism::whole_table_transform, 0},
        {Mechanism::builds, 0.003},         {Mechanism::builds, 0.01},
        {Mechanism::builds, 0.03},          {Mechanism::builds_of_vclip, 0.003},
        {Mechanism::builds_of_vclip, 0.01}, {Mechanism::builds_of_vclip, 0.03},
        {Mechanism::capped_cycles, 10},     {Mechanism::capped_cycles, 30},
        {Mechanism::capped_cycles, 60},     {Mechanism::first_touches, 0}};
    std::size_t steps = 60, filling = 10;  ///< traced; of them, those before the counted ones
    std::uint64_t seed = 1;

    /// Returns the seed of a point on the axis of speed: each point has its own arrangement of bodies.
    [[nodiscard]] std::uint64_t seed_of(std::size_t speed) const { return seed * speeds.size() + speed; }
};

/// The calibration of a machine at a time step.
struct Calibration {
    std::size_t machine = 0;
    double time_step = 0, ns_per_read = 0;
    std::vector<CalibrationPoint> points;
};

/// Cost of building a table, in reads' worth of time, measured on this machine.
struct BuildCost {
    std::string algorithm, shape;
    double reads = 0;
};

struct Factorial {
    std::vector<OldMachine> machines;
    std::vector<Calibration> calibrations;
    std::vector<BuildCost> builds;
    std::vector<Outcome> outcomes;
    double cycles = 0, vclip_queries = 0;
};

/// Returns the factorial; without outcomes if it was stopped. Throws std::invalid_argument if this program
/// lacks a table type. `on_trace` is called for each scene.
[[nodiscard]] Factorial run_factorial(const Levels& levels, const std::function<void()>& on_trace,
                                      const std::atomic<bool>& stop);

/// Returns how many scenes the factorial traces.
[[nodiscard]] std::size_t scenes_to_trace(const Levels& levels);

// The time of a query under one setting of the factorial: the demand of its scene, and what the mechanism
// adds.

/// What a time depends on.
struct TimedScene {
    const OldMachine* machine = nullptr;
    const MemorySizes* sizes = nullptr;
    const MemoryDemand* demand = nullptr;
    double ns_per_read = 0;
    double build_reads = 0;                   ///< of a table, in reads' worth of time
    bool is_vclip = false, is_large = false;  ///< of 386 vertices
};

/// Arithmetic of turning 32 bytes, a plane of four doubles, to world space: 21 operations, one per cycle of a
/// processor of the time.
inline constexpr double cycles_per_turned_line = 21;
/// Reads of a feature step of V-Clip: about the 228 of a slow query of 386 vertices over its 3 to 4 steps.
inline constexpr double reads_per_feature_step = 60;
/// Iterations that the paper's times of one point are means of.
inline constexpr double papers_iterations = 30000;

/// ns per query.
[[nodiscard]] double query_ns(const TimedScene& scene, const Setting& setting);

}  // namespace edgewise::studies::thrash
