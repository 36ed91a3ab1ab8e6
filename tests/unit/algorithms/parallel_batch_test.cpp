// SPDX-License-Identifier: MIT
//
// Batches, in lanes or not, over threads: every answer and every pair left behind to the bit those of single
// queries, for all widths and numbers of threads; and the requested number of threads is used.
#include "edgewise/algorithms/parallel_batch.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <set>
#include <thread>
#include <type_traits>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lazy.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/linked.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "pair_crowd.hpp"

namespace edgewise {
namespace {

// A table that queries write to is for one thread at a time: no batch over threads takes it.
static_assert(ShareableTable<aos<f64>> && ShareableTable<points_soa<f32>> && !ShareableTable<lazy<f64>>);
// Handles that are addresses fit no lane.
static_assert(!NumberedTable<linked<f64>>);

template <class TableType, class AlgorithmType>
struct Asked {
    using Table = TableType;
    using Algorithm = AlgorithmType;
};

template <class Case>
class ParallelBatches : public ::testing::Test {
  protected:
    /// TBB starts one thread per core; this test needs four on any machine.
    tbb::global_control four_{tbb::global_control::max_allowed_parallelism, 4};
};
using AskedCases =
    ::testing::Types<Asked<points_soa<f64>, Gjk>, Asked<points_soa<f32>, Gjk>, Asked<points_soa<mixed>, Gjk>,
                     Asked<lean<f64>, Gjk>, Asked<lean<f32>, Gjk>, Asked<aos<f64>, Gjk>,
                     Asked<linked<f64>, Gjk>, Asked<lean<f32>, VClip>, Asked<aos<f64>, VClip>>;
TYPED_TEST_SUITE(ParallelBatches, AskedCases);

struct Differences {
    std::size_t different = 0, separated = 0, overlapping = 0;
};

/// Frame after frame, both ways from cold on.
template <class Case>
Differences differences(bool in_lanes, int threads, const QueryOptions& options) {
    using Table = typename Case::Table;
    using Algorithm = typename Case::Algorithm;
    constexpr std::size_t count = 1500;
    PairCrowd<Table, Algorithm> crowd(count);
    Differences found;
    for (const double step : {0.0, 0.01, 0.3}) {
        crowd.move(step);
        const std::vector<Distance> expected = crowd.one_by_one(options);
        std::vector<Distance> answers(count);
        query_batch_parallel<Table, Table, Algorithm>(crowd.queries, answers, options, threads, in_lanes);
        for (std::size_t i = 0; i < count; ++i) {
            found.different +=
                !same_bits(expected[i], answers[i]) || crowd.single_pairs[i] != crowd.batch_pairs[i];
            found.separated += expected[i].status == Status::separated;
            found.overlapping += expected[i].status == Status::overlapping;
        }
    }
    return found;
}

TYPED_TEST(ParallelBatches, AreToTheBitSingleQueriesInAnyNumberOfThreads) {
    for (const bool in_lanes : {false, has_lanes()}) {
        for (const int threads : {1, 2, 4}) {
            const Differences found = differences<TypeParam>(in_lanes, threads, {});
            EXPECT_EQ(found.different, 0U) << threads << " threads, lanes: " << in_lanes;
            EXPECT_GT(found.separated, 1000U);
            EXPECT_GT(found.overlapping, 100U);
            if (threads == 4)
                std::printf("%s lanes, 4 threads: %zu separated, %zu overlapping, %zu differ\n",
                            in_lanes ? "in" : "no", found.separated, found.overlapping, found.different);
        }
    }
}

TYPED_TEST(ParallelBatches, HonourTheOptions) {
    for (const QueryOptions& options :
         {QueryOptions{.contact_tolerance = 0.3}, QueryOptions{.gap_tolerance = 1e-2},
          QueryOptions{.cutoff = 0}, QueryOptions{.sub_distance = SubDistanceSolver::johnson}})
        EXPECT_EQ(differences<TypeParam>(has_lanes(), 4, options).different, 0U);
}

TYPED_TEST(ParallelBatches, TakeAnyNumberOfQueries) {
    using Table = typename TypeParam::Table;
    using Algorithm = typename TypeParam::Algorithm;
    for (const std::size_t count : {0U, 1U, 3U, 17U, 33U, 257U}) {
        PairCrowd<Table, Algorithm> crowd(count);
        const std::vector<Distance> expected = crowd.one_by_one({});
        std::vector<Distance> answers(count);
        query_batch_parallel<Table, Table, Algorithm>(crowd.queries, answers, {}, 4);
        for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(same_bits(expected[i], answers[i])) << i;
    }
}

/// Cold pairs, but those of a body with more than 64 vertices.
TEST(GjkBatch, SearchesInLanes) {
    if (!has_lanes()) GTEST_SKIP() << "this processor has no lanes";
    using Table = lean<f64>;
    PairCrowd<Table> crowd(4000);
    const auto is_large = [](const auto& query) {
        return std::max(query.a->vertex_count(), query.b->vertex_count()) > SingleVertices::most;
    };
    const auto large = std::ranges::count_if(crowd.queries, is_large);
    std::vector<Distance> answers(crowd.queries.size());
    GjkBatch<Table, Table> batch(crowd.queries, answers, {});
    batch.run();
    std::printf("%zu of %zu queries asked singly\n", batch.asked_singly(), answers.size());
    EXPECT_EQ(batch.asked_singly(), static_cast<std::size_t>(large));
    EXPECT_GT(large, 10);
}

/// Tables were rebuilt since the last query: their pairs start cold.
TEST(GjkBatch, FollowsNoHandleOfARebuiltTable) {
    using Table = points_soa<f64>;
    PairCrowd<Table> crowd(500);
    static_cast<void>(crowd.one_by_one({}));
    crowd.batch_pairs = crowd.single_pairs;
    for (Table& table : crowd.tables) table = Table(scene::make_shape("tetra4").or_throw(), Parts::support);
    const std::vector<Distance> expected = crowd.one_by_one({});
    std::vector<Distance> answers(crowd.queries.size());
    query_batch<Table, Table>(crowd.queries, answers);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_TRUE(same_bits(expected[i], answers[i])) << i;
}

/// GJK that notes the threads that ask it, and waits until enough have, up to ten seconds.
struct WatchedGjk : Gjk {
    static inline std::mutex mutex;
    static inline std::set<std::thread::id> seen;
    static inline std::size_t wanted = 0;
    static inline std::chrono::steady_clock::time_point give_up;

    static void watch(std::size_t threads) {
        seen.clear();
        wanted = threads;
        give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    }

    template <class Table>
    static Distance query(const Table& a, const Table& b, const Transform<double>& a_from_b,
                          SimplexPair<Table, Table>& pair, const QueryOptions& options) {
        const auto enough = [] {
            const std::scoped_lock lock(mutex);
            seen.insert(std::this_thread::get_id());
            return seen.size() >= wanted;
        };
        while (!enough() && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
        return Gjk::query(a, b, a_from_b, pair, options);
    }
};

TEST(ParallelBatch, AsksInSoManyThreads) {
    using Table = lean<f64>;
    const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
    PairCrowd<Table, WatchedGjk> crowd(2000);
    for (const std::size_t threads : {1U, 2U, 4U}) {
        WatchedGjk::watch(threads);
        std::vector<Distance> answers(crowd.queries.size());
        query_batch_parallel<Table, Table, WatchedGjk>(crowd.queries, answers, {}, static_cast<int>(threads));
        EXPECT_EQ(WatchedGjk::seen.size(), threads);
    }
}

TEST(ParallelBatch, PartsAreSomeHundredsOrGoRound) {
    const tbb::task_arena arena(4);
    EXPECT_EQ(queries_per_part(100'000, arena), 256U);
    EXPECT_EQ(queries_per_part(1600, arena), 100U);
    EXPECT_EQ(queries_per_part(10, arena), 32U);
}

}  // namespace
}  // namespace edgewise
