// SPDX-License-Identifier: MIT
//
// The work of one cell's queries, on a table type of ours or in another library: instructions,
// mispredicted branches and cache misses that Callgrind counts, next to steps, support points, vertices and
// lines from traces, and next to a floor. Counts and models: nothing is timed.
//
// Passes are counted as the difference of two runs with different numbers of passes, divided by the
// difference and by the queries: work before the first pass and after the last cancels. A pass resets
// pairs, which is counted; poses are converted to a library's own type before. Branches are mispredicted by
// Callgrind's predictor, not by a processor; misses are of two levels of least-recently-used caches.
//
// The effort run does so for one scene and shape, several table types, algorithms and peers: a row of the
// store for each.
//
// A floor for the work of a query: the work of a proof that the distance is right. The proof receives the
// answer as a hint, so it does not search.
//
// Separated bodies: the proof shows that no vertex of A is farther along the answer's direction, and no
// vertex of B farther against it. In a convex body a vertex that is no lower than its neighbours is the
// highest. So the proof reads one vertex of the nearest feature (the one with the fewest neighbours) and its
// neighbours. A table that stores no neighbours is read whole. Each vertex read takes one dot product of 5
// flops. Turning the direction into B's frame takes 15; the offset of the frames along it, and the sum of the
// three terms, take 7. Comparisons are no flops.
//
// Bodies in contact: the proof shows a point in both. Five vertices of the two bodies together are enough
// (Kirchberger's theorem), and needed in general position. Their weights are the hint: 3 (2 x 5 - 2) flops
// for the two weighted sums, and 18 to turn B's sum into A's frame.
//
// Lines: the fewest lines of 64 bytes that the coordinates of the vertices read can fill, table by table, in
// any layout. Neighbours' numbers, poses and pair caches are not counted.
//
// The floor does not bound every proof. A table that stores planes proves the side of a face by its plane
// alone; and a query must also find the answer. It is the floor of proofs by heights of vertices; all cells
// are compared to it.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/named_answer.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/process/callgrind.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

// Passes over one cell's queries in a process of its own, for tools that watch whole programs, and
// Callgrind's counts of the passes.

/// Returns the hidden command that runs one pass to warm up, then the number of passes to be counted, and
/// nothing else (cli/command_crosscheck.cpp).
[[nodiscard]] std::vector<std::string> pass_command(const CellChoice& choice, const std::string& program,
                                                    int passes);

/// Counts the passes under Callgrind, all together. `program`: Edgewise, built for a processor that Valgrind
/// knows. Several calls may run at a time.
[[nodiscard]] measure::Expected<measure::CallgrindCounts> callgrind_pass(
    const CellChoice& choice, const measure::CacheGeometry& geometry, const std::string& program,
    int passes = 1);

/// Counts the same passes instruction by instruction (`--dump-instr=yes`); the counts are equal.
[[nodiscard]] measure::Expected<measure::CallgrindLines> callgrind_lines(
    const CellChoice& choice, const measure::CacheGeometry& geometry, const std::string& program, int passes);

/// Returns a program that Valgrind can run: this one, or edgewise_sim next to it; else how to build one.
[[nodiscard]] measure::Expected<std::string> program_for_valgrind();

/// Means per query.
struct ProofFloor {
    double vertices = 0, flops = 0, lines = 0;
};

/// What of a table the floor depends on.
struct ProofReads {
    bool knows_neighbours = true;
    double vertex_bytes = 0;  ///< of the coordinates of one vertex
};

/// Vertices that a proof reads that nothing of the body is higher along `direction` (in its frame).
[[nodiscard]] std::size_t proof_vertices(const Polyhedron& body, const Vec3d& direction,
                                         bool knows_neighbours);

/// Computes the floor over all queries of the workload, with these bodies. Unknown: without queries.
[[nodiscard]] measure::Expected<ProofFloor> proof_floor(const scene::Workload& workload,
                                                        std::span<const Polyhedron> bodies,
                                                        const ProofReads& reads);

/// Passes of the two runs; their difference is counted.
inline constexpr int few_passes = 1, many_passes = 3;

/// Means per query over all queries of the scene.
struct Effort {
    std::string table, algorithm;
    bool is_peer = false;
    std::string wrong;  ///< of checked answers; empty: all are right. A peer's are its own to have
    double table_bytes = 0, object_bytes = 0, pair_bytes = 0;  ///< of one shape's table, and of a pair
    bench::PassSum passed;                                     ///< what one pass of the queries gives
    measure::Expected<measure::CallgrindCounts> counted = measure::Refusal{"not counted yet"};
    measure::Expected<double> steps, vertices_read, lines_read;
    measure::Expected<ProofFloor> floor;
};

/// Counts of one query: those of `many` passes less those of `few`, divided by the difference in passes and
/// by the queries. Unknown if the run of more passes counted less.
[[nodiscard]] measure::Expected<measure::CallgrindCounts> counts_per_query(
    const measure::CallgrindCounts& few, const measure::CallgrindCounts& many, int passes, double queries);

/// Returns what is wrong with the sums that another program's pass printed; empty if they match this sum.
/// Our tables must match to the last bit. A peer's adapter is compiled for another processor there, so its
/// sums must match only as far as answers of single precision are right.
[[nodiscard]] std::string compare_passes(const std::string& printed, const bench::PassSum& expected,
                                         bool is_peer);

/// Fills in everything except `counted`. Nothing else may allocate at the same time, because the heap shows
/// how much a library's shapes take. Throws std::invalid_argument for a cell that cannot be made.
[[nodiscard]] Effort examine(const CellChoice& choice);

/// Runs a program for Valgrind once; returns what is wrong with its passes, empty if they equal the checked
/// passes.
[[nodiscard]] std::string check_program(const CellChoice& choice, const Effort& effort,
                                        const std::string& program);

/// Counts an effort that was examined, in processes of their own. `program`: as program_for_valgrind
/// returns it.
[[nodiscard]] measure::Expected<measure::CallgrindCounts> count_effort(
    const CellChoice& choice, const Effort& effort, const measure::Expected<measure::CacheGeometry>& geometry,
    const measure::Expected<std::string>& program);

/// Default machine: Callgrind simulates its first two levels.
inline constexpr const char* effort_machine = "skylake_sp";

/// Default cell: pairs that turn as in a simulation, with bodies large enough to climb on.
inline const CellChoice effort_cell = {.scene = "tumble",
                                       .shape = "sphere386",
                                       .parameters = {{"rotation_step", 0.1}},
                                       .queries = 200,
                                       .checked = 50};

struct EffortPlan {
    CellChoice cell = effort_cell;  ///< scene, shape, parameters, queries, seed: of every row
    std::vector<const bench::TableType*> types, peers;
    std::vector<std::string> algorithms;
    measure::MachineChoice machine;
};

/// Table type and algorithm, or peer, of a row, and the choice that runs it.
struct EffortContender {
    const bench::TableType* type;
    CellChoice choice;
};

/// Returns the contenders in the order of the rows: table types with their algorithms, then peers.
[[nodiscard]] std::vector<EffortContender> contenders(const EffortPlan& plan);

/// Returns the machine's first two levels as Callgrind simulates them, or why it cannot.
[[nodiscard]] measure::Expected<measure::CacheGeometry> geometry_of(const measure::MachineChoice& choice);

/// Returns figures, each a number or the reason for none. `machine`: its name, for figures of caches.
[[nodiscard]] std::vector<store::FigureRow> effort_figures(const Effort& effort, const std::string& machine);

/// Examines rows for which `wanted` is true one after the other, then counts several at a time. Calls
/// `on_row` for each, one at a time, with its place in the plan's order. Returns false if it was stopped
/// before the last row.
[[nodiscard]] bool run_effort(const EffortPlan& plan,
                              const std::function<bool(const store::CellRow&)>& wanted,
                              const std::function<void(std::size_t place, const store::StoredCell&)>& on_row,
                              const std::atomic<bool>& stop);

/// Runs as run_effort and writes to the store; skips rows that are already counted there.
[[nodiscard]] bool store_effort(
    const EffortPlan& plan, const std::string& build, store::Store& store,
    const std::function<void(std::size_t place, const store::StoredCell&)>& on_row,
    const std::atomic<bool>& stop);

}  // namespace edgewise::studies
