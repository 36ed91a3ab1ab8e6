// SPDX-License-Identifier: MIT
//
// Possible causes of figure 8: every combination of the conditions that the paper leaves open is scored by
// the four facts that the figure states. Demands are traced once (memory_demand.hpp). The rest is arithmetic,
// so it is the same on every machine, except the cost of building
// a table, which is measured here.
//
// The four facts that figure 8 states (section 4), each a number and a rule. The time axes of figures 7 and 8
// have marks at their ends only, 1e-4 s and 1.2e-3 s: a maximum is known to a factor of two at best.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/studies/thrash/memory_demand.hpp"

namespace edgewise::studies::thrash {

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
