// SPDX-License-Identifier: MIT
//
// A batch over threads: parts of it, disjoint, by oneTBB (Debian: libtbb-dev). Pairs are independent, so
// every answer is to the bit that of a single query, in any thread and any part.
//
// The one header that includes TBB. The package does not link it: a program that includes this header links
// TBB::tbb itself (find_package(TBB)), and others need no TBB.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

#include "edgewise/algorithms/query_batch.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Most queries that a thread takes at once: some hundred, so that the cost of handing them out is
/// negligible; fewer if a batch is too small for all threads.
[[nodiscard]] inline std::size_t queries_per_part(std::size_t queries, const tbb::task_arena& arena) {
    constexpr std::size_t parts_each = 4, least = 32, most = 256;
    const auto threads = static_cast<std::size_t>(arena.max_concurrency());
    return std::clamp(queries / (parts_each * threads), least, most);
}

/// Tables that several threads may query at once: all except those that queries write to, such as `lazy`.
template <class Table>
concept ShareableTable = SupportTable<Table> && !queries_write<Table>;

/// Runs query_batch in all threads of the arena. For callers with many batches: they keep the arena.
template <ShareableTable TableA, ShareableTable TableB, class Algorithm = Gjk>
void query_batch_parallel(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                          const QueryOptions& options, tbb::task_arena& arena,
                          LaneWidth width = best_lanes()) {
    assert(queries.size() == answers.size());
    using Range = tbb::blocked_range<std::size_t>;
    const auto ask = [&](const Range& part) {
        query_batch<TableA, TableB, Algorithm>(queries.subspan(part.begin(), part.size()),
                                               answers.subspan(part.begin(), part.size()), options, width);
    };
    arena.execute([&] {
        tbb::parallel_for(Range(0, queries.size(), queries_per_part(queries.size(), arena)), ask,
                          tbb::simple_partitioner());
    });
}

/// Answers queries[i] in answers[i] in at most `threads` threads, including the caller's; 1 or more. TBB runs
/// no more of them than the machine has cores (unless tbb::global_control differs). Returns when all is done.
template <ShareableTable TableA, ShareableTable TableB, class Algorithm = Gjk>
void query_batch_parallel(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                          const QueryOptions& options, int threads, LaneWidth width = best_lanes()) {
    assert(threads >= 1);
    tbb::task_arena arena(threads);
    query_batch_parallel<TableA, TableB, Algorithm>(queries, answers, options, arena, width);
}

}  // namespace edgewise
