// SPDX-License-Identifier: MIT
//
// The interface of a probe: what a sweep lays before it, and the figures it makes of it. Probes know no
// algorithm and no layout; what they need of them comes as plain numbers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/algorithm_work.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/measure/cache/scene_trace.hpp"
#include "edgewise/measure/counters/count_pass.hpp"
#include "edgewise/measure/figure.hpp"
#include "edgewise/measure/heap_use.hpp"
#include "edgewise/measure/memory_use.hpp"
#include "edgewise/measure/round.hpp"
#include "edgewise/measure/step_costs.hpp"

namespace edgewise::measure {

/// A part of a table and what it takes.
struct ComponentBytes {
    std::string name;
    double bytes;
};

/// The bytes of one body's table, by component; sizes of a family are how slopes are measured.
struct TableBytes {
    std::uint64_t vertices = 0, edges = 0;
    std::vector<ComponentBytes> components;
    double paper_subtotal = 0;  ///< 0: this table stores no Voronoi planes
    double total = 0;
};

/// One answer beside the exact one.
struct CheckedAnswer {
    bool separated = false, touching = false;  ///< exactly; else overlapping
    bool verdict_wrong = false, in_band = false;
    double error_stored = 0;   ///< |d - d*| / scale, d* of the bodies that the table holds
    double given_away = 0;     ///< what of it was allowed as a tolerance
    double error_given = 0;    ///< the same, d* of the bodies as given
    double witness_error = 0;  ///< | |p_a - p_b| - d | / scale; separated answers only
    /// Whether the verdict is another than the paper's control gives; nothing where it was not asked or has
    /// no answer.
    std::optional<bool> control_disagrees;
};

/// What was counted over all queries of the cell.
struct AnswerCounts {
    std::uint64_t queries = 0, steps = 0, fallbacks = 0, cycles = 0;
    int max_steps = 0;
    std::uint64_t refinements = 0, escapes = 0;
    std::uint64_t warm = 0, unchanged = 0;  ///< started warm; and of these ended where they started
};

/// A cell as probes see it.
struct Subject {
    TableBytes table;                   ///< the scene's first body
    std::span<const TableBytes> sizes;  ///< the same table type over a family of triangulated bodies, growing
    std::span<const CheckedAnswer> checked;
    AnswerCounts counts;
    std::span<const Round> rounds;
    MemoryUse memory;  ///< of all tables of the cell
    BuildTimes build;  ///< of the scene's first body
    LinesTouched touched;
    const SceneTrace* trace = &no_trace();
    HeapUse heap;
    StepCosts costs;  ///< of the scene's steps
    AlgorithmWork work;
    std::vector<PassRecord> counted;  ///< by the processor and the kernel, of a pass in the steady state
};

class Probe {
  public:
    Probe() = default;
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;
    virtual ~Probe() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual std::string_view summary() const = 0;
    [[nodiscard]] virtual std::vector<Figure> figures(const Subject& subject) const = 0;
};

/// Every probe of this program, in the order of the manifest probes/CMakeLists.txt.
[[nodiscard]] std::span<const std::unique_ptr<Probe>> registered_probes();

}  // namespace edgewise::measure
