// SPDX-License-Identifier: MIT
//
// Where the work of one cell's queries goes, of a table type of ours or of another library: instructions,
// mispredicted branches and cache misses that Callgrind counts, beside what traces tell of steps, support
// points, vertices and lines, and beside a floor (proof_floor.hpp). Counts and models: nothing is timed.
//
// Counted are passes, as the difference of two runs of different numbers of passes divided by that many
// passes and queries: what a program does before its first pass and after its last falls out. A pass sets
// pairs back, which is counted; poses are in a library's own type before. Branches are those of Callgrind's
// predictor, not of a processor's; misses those of two levels of least-recently-used caches.
#pragma once

#include <string>

#include "edgewise/bench/named_answer.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/process/callgrind.hpp"
#include "edgewise/studies/proof_floor.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

/// Of the two runs whose difference is counted.
inline constexpr int few_passes = 1, many_passes = 3;

/// Means per query over all queries of the scene.
struct Effort {
    std::string layout, precision, table, algorithm;
    bool is_peer = false;
    std::string wrong;  ///< of checked answers; empty: all are right. A peer's are its own to have
    std::size_t vertices = 0, edges = 0, faces = 0;
    double table_bytes = 0, object_bytes = 0, pair_bytes = 0;  ///< of one shape's table, and of a pair
    bench::PassSum passed;                                     ///< what one pass of the queries gives
    measure::Expected<measure::CallgrindCounts> counted = measure::Refusal{"not counted yet"};
    measure::Expected<double> steps, supports, vertices_read, lines_read;
    measure::Expected<ProofFloor> floor;
};

/// One pass of two runs' counts: of `many` passes and of `few`, divided by the passes and queries between
/// them. Unknown where a run of more passes counted less.
[[nodiscard]] measure::Expected<measure::CallgrindCounts> counts_per_query(
    const measure::CallgrindCounts& few, const measure::CallgrindCounts& many, int passes, double queries);

/// What is wrong with what the pass of another program printed; empty: it gave this sum, to the last bit of
/// ours; of a peer, whose adapter's arithmetic is compiled for another processor there, as far as answers of
/// single precision are right.
[[nodiscard]] std::string compare_passes(const std::string& printed, const bench::PassSum& expected,
                                         bool is_peer);

/// All but `counted`. Nothing else may allocate meanwhile: what a library's shapes take is seen on the heap.
/// Throws std::invalid_argument for a cell that cannot be made.
[[nodiscard]] Effort examine(const CellChoice& choice);

/// What is wrong with the passes of a program for Valgrind, which is run once; empty: they are those that
/// were checked.
[[nodiscard]] std::string check_program(const CellChoice& choice, const Effort& effort,
                                        const std::string& program);

/// The rest, of an effort that was examined, in processes of their own. `program`: as program_for_valgrind
/// says.
[[nodiscard]] measure::Expected<measure::CallgrindCounts> count_effort(
    const CellChoice& choice, const Effort& effort, const measure::Expected<measure::CacheGeometry>& geometry,
    const measure::Expected<std::string>& program);

}  // namespace edgewise::studies
