// SPDX-License-Identifier: MIT
//
// Possible causes of figure 8: every combination of the conditions that the paper leaves open is scored by
// the four facts that the figure states (figure_8_facts.hpp). Demands are traced once (memory_demand.hpp).
// The rest is arithmetic (memory_demand.hpp), so it is the same on every machine, except the cost of building
// a table, which is measured here.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "edgewise/studies/thrash/figure_8_facts.hpp"
#include "edgewise/studies/thrash/memory_demand.hpp"

namespace edgewise::studies::thrash {

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

}  // namespace edgewise::studies::thrash
