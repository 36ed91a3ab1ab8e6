// SPDX-License-Identifier: MIT
//
// One scene on one body with every cell that a guard on speed times there: table types, algorithms, and GJK
// asked in batches where pairs are cold. The first cell is the reference.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/studies/gate/run.hpp"
#include "edgewise/sweep/prepared_cell.hpp"

namespace edgewise::studies {

// Measures the speed of this machine independently of algorithms and layouts, about half of the time each: a
// chain of dependent multiplications, limited by the clock, and a walk along pointers through a
// buffer larger than a first-level and smaller than a second-level cache, limited by the caches.

class GateKernel {
  public:
    GateKernel();

    /// Time of one run in ns, with the buffer in cache.
    [[nodiscard]] double time_ns() const;

  private:
    /// A node fills one cache line.
    struct alignas(64) Node {
        const Node* next = nullptr;
    };

    [[nodiscard]] const Node* walk(const Node* from, int steps) const;

    std::vector<Node> nodes_;
};

/// A scene of the fixed set under a name of its own.
struct GateScene {
    const char* name;
    const char* kind;
    scene::SceneParameters parameters;
};

[[nodiscard]] const std::vector<GateScene>& gate_scenes();
[[nodiscard]] const std::vector<std::string>& gate_shapes();

class GateGroup {
  public:
    /// Makes every cell and checks its answers; errors go to `wrong`. Throws like run_gate.
    GateGroup(const GatePlan& plan, const GateScene& scene, const std::string& shape,
              std::vector<std::string>& wrong);

    /// Times every cell and the kernel once, in an order drawn for this round.
    void time_round(int number, const GateKernel& kernel, double clock_cost_ns);

    /// Returns the rows over all rounds. Throws std::invalid_argument if there are too few rounds.
    [[nodiscard]] std::vector<measure::RecordRow> rows() const;

  private:
    struct Cell {
        std::string name;  ///< "gjk lean_f64 cold cube8 batch=yes"
        const char* figure = over_reference;
        sweep::PreparedCell cell;
        std::vector<double> ns;  ///< per query, round by round
    };

    sweep::SharedQueries shared_;
    std::vector<Cell> cells_;
    std::vector<double> kernel_ns_;
};

}  // namespace edgewise::studies
