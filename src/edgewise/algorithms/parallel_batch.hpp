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

#if defined(__SANITIZE_THREAD__)
#define EDGEWISE_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define EDGEWISE_THREAD_SANITIZER
#endif
#endif
#ifdef EDGEWISE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace edgewise {

/// Tells ThreadSanitizer the order of a batch: all its parts run after the caller starts it, and before it
/// returns. TBB keeps this order, but Debian's libtbb is not instrumented, so the sanitizer cannot see it.
/// Without the sanitizer it is nothing.
class BatchOrder {
  public:
    void before() { release(&start_); }       ///< by the caller, before any part
    void part_starts() { acquire(&start_); }  ///< by the thread of the part
    void part_ends() { release(&end_); }      ///< by the thread of the part
    void after() { acquire(&end_); }          ///< by the caller, after all parts

  private:
#ifdef EDGEWISE_THREAD_SANITIZER
    static void acquire(char* event) { __tsan_acquire(event); }
    static void release(char* event) { __tsan_release(event); }
#else
    static void acquire(char*) {}
    static void release(char*) {}
#endif
    char start_ = 0;
    char end_ = 0;
};

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
                          const QueryOptions& options, tbb::task_arena& arena, bool in_lanes = has_lanes()) {
    assert(queries.size() == answers.size());
    using Range = tbb::blocked_range<std::size_t>;
    BatchOrder order;
    const auto ask = [&](const Range& part) {
        order.part_starts();
        query_batch<TableA, TableB, Algorithm>(queries.subspan(part.begin(), part.size()),
                                               answers.subspan(part.begin(), part.size()), options, in_lanes);
        order.part_ends();
    };
    order.before();
    arena.execute([&] {
        tbb::parallel_for(Range(0, queries.size(), queries_per_part(queries.size(), arena)), ask,
                          tbb::simple_partitioner());
    });
    order.after();
}

/// Answers queries[i] in answers[i] in at most `threads` threads, including the caller's; 1 or more. TBB runs
/// no more of them than the machine has cores (unless tbb::global_control differs). Returns when all is done.
template <ShareableTable TableA, ShareableTable TableB, class Algorithm = Gjk>
void query_batch_parallel(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                          const QueryOptions& options, int threads, bool in_lanes = has_lanes()) {
    assert(threads >= 1);
    tbb::task_arena arena(threads);
    query_batch_parallel<TableA, TableB, Algorithm>(queries, answers, options, arena, in_lanes);
}

}  // namespace edgewise
