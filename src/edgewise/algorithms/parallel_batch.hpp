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
#include <functional>
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

/// Tells ThreadSanitizer, as acquire_event does, that what precedes the release of an event happens before
/// what follows its acquisition: Debian's libtbb, which keeps this order, is not instrumented.
inline void release_event([[maybe_unused]] char* event) {
#ifdef EDGEWISE_THREAD_SANITIZER
    __tsan_release(event);
#endif
}
inline void acquire_event([[maybe_unused]] char* event) {
#ifdef EDGEWISE_THREAD_SANITIZER
    __tsan_acquire(event);
#endif
}

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

/// Calls ask(first, count) for all parts of that many queries, in all threads of the arena. Not a template,
/// so that a program compiles TBB's loop once.
inline void ask_parts(std::size_t queries, tbb::task_arena& arena,
                      const std::function<void(std::size_t first, std::size_t count)>& ask) {
    using Range = tbb::blocked_range<std::size_t>;
    char start = 0, end = 0;  // the parts run after the caller starts them, and before it returns
    const auto ask_part = [&](const Range& part) {
        acquire_event(&start);
        ask(part.begin(), part.size());
        release_event(&end);
    };
    release_event(&start);
    arena.execute([&] {
        tbb::parallel_for(Range(0, queries, queries_per_part(queries, arena)), ask_part,
                          tbb::simple_partitioner());
    });
    acquire_event(&end);
}

/// Runs query_batch in all threads of the arena. For callers with many batches: they keep the arena.
template <ShareableTable TableA, ShareableTable TableB, class Algorithm = Gjk>
void query_batch_parallel(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                          const QueryOptions& options, tbb::task_arena& arena, bool in_lanes = has_lanes()) {
    assert(queries.size() == answers.size());
    const auto ask = [&](std::size_t first, std::size_t count) {
        query_batch<TableA, TableB, Algorithm>(queries.subspan(first, count), answers.subspan(first, count),
                                               options, in_lanes);
    };
    ask_parts(queries.size(), arena, std::ref(ask));  // by reference: nothing is allocated
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
