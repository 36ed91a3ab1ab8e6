// SPDX-License-Identifier: MIT
//
// How queries scale over threads, in two ways of sharing. Shared: all threads ask one set of tables, each
// frame's batch divided among them (algorithms/parallel_batch.hpp); what does not scale is the handing out,
// the wait for a frame's last part, and the caches. Apart: each thread asks tables, pairs and poses of its
// own, and never waits; a thread still loses time to the others in the cache and the memory that they share,
// and a clock that falls when more cores work. Threads go where the system puts them, and with simultaneous
// multithreading two may be on one core.
//
// Every measurement is a pass that fills caches, then a timed pass. Numbers of threads and ways of sharing
// take turns in every round, and only times of the same round are compared.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

/// A copy of a cell's workload and tables that shares nothing with another copy.
class CellCopy {
  public:
    /// Throws std::invalid_argument as SingleCell.
    CellCopy(const SingleCell& cell, const bench::RunnerOptions& options);

    [[nodiscard]] bench::ThreadedPass& pass() const { return *pass_; }

  private:
    std::unique_ptr<scene::Workload> workload_;
    sweep::PreparedCell cell_;
    std::unique_ptr<bench::ThreadedPass> pass_;
};

struct TimedPass {
    double ns = 0;
    double sum = 0;  ///< as ThreadedPass::sum
};

/// Times one pass with this number of threads, after one that fills caches.
[[nodiscard]] TimedPass time_shared(bench::ThreadedPass& pass, int threads);

/// Times one pass of each copy, one thread per copy. Timing starts after all threads have made one pass, and
/// a thread that is done goes on until all are: the others are busy during the whole of a timed pass.
[[nodiscard]] std::vector<TimedPass> time_apart(std::span<const CellCopy> copies);

/// Default cell: a table for each of 600 bodies, more than a second-level cache holds.
inline const CellChoice scaling_cell = {.table = "lean_f64",
                                        .algorithm = "vclip",
                                        .scene = "pressure",
                                        .shape = "sphere386",
                                        .queries = 6000,
                                        .checked = 50};

struct ScalingPlan {
    CellChoice cell = scaling_cell;
    std::vector<int> threads = {1};  ///< as scaling_threads gives them
    int rounds = 9;
};

/// Medians over rounds.
struct WayOfSharing {
    double queries_per_second = 0;  ///< of all threads
    double speed_up = 0;            ///< over one thread in the same way
    double efficiency = 0;          ///< speed-up over threads
};

struct ScalingRow {
    int threads = 1;
    WayOfSharing shared, apart;
    double contention = 0;  ///< apart: a thread's time for its pass with the others running, over one alone
};

struct Scaling {
    std::string table, algorithm;
    std::size_t queries = 0, frames = 0;  ///< of a pass
    double table_bytes = 0;               ///< of all tables of one set
    int rounds = 0;                       ///< that ended
    std::size_t checked = 0;              ///< answers held against exact ones
    std::size_t passes = 0;               ///< passes with a sum that was compared with that of single queries
    std::string wrong;                    ///< empty: all are right
    std::vector<ScalingRow> rows;         ///< in the plan's order; none where something is wrong
};

/// Cores that this process may use.
[[nodiscard]] int usable_cores();

/// Returns the thread counts to measure: 1 and those asked for, once each and in order; else 1, 2, 4, ... and
/// all cores. Throws std::invalid_argument for more than there are: those would take turns, not scale.
[[nodiscard]] std::vector<int> scaling_threads(std::span<const int> asked, int cores);

/// Returns "", or what is wrong with a pass of this many threads: its sum must equal that of single queries
/// to the last bit.
[[nodiscard]] std::string compare_sums(double sum, double single, int threads, const char* that_do);

/// on_round is called after each round. Rows are of the rounds that were done when `stop` was seen, if any.
/// Throws std::invalid_argument for a cell that cannot be made, or asks for what batches do not answer.
[[nodiscard]] Scaling measure_scaling(const ScalingPlan& plan, const std::function<void()>& on_round,
                                      const std::atomic<bool>& stop);

}  // namespace edgewise::studies
