// SPDX-License-Identifier: MIT
//
// A workload's queries as frames of batches: the same answers as one by one, in the bits of their sum,
// however many threads ask, and no pair twice in a frame.
#include "edgewise/bench/frame_batches.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

struct FramedScene {
    const char* kind;
    scene::SceneParameters parameters;
    bool is_one_frame;
};

const FramedScene framed_scenes[] = {{"cold", {}, true},
                                     {"tumble", {}, false},
                                     {"tumble", {{"in_time_order", 1}}, false},
                                     {"pressure", {{"bodies", 40}, {"new_order", 1}}, false}};

studies::SingleCell framed_cell(const FramedScene& scene, const char* table, const char* algorithm) {
    return studies::SingleCell({.table = table,
                                .algorithm = algorithm,
                                .scene = scene.kind,
                                .shape = "sphere18",
                                .parameters = scene.parameters});
}

TEST(FrameBatches, HaveTheSumOfSingleQueriesInAnyNumberOfThreads) {
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    for (const FramedScene& scene : framed_scenes) {
        for (const auto& [table, algorithm] : {std::pair{"lean_f64", "vclip"},
                                               {"lean_f32", "gjk"},
                                               {"linked_f64", "gjk"},
                                               {"aos_f64", "vclip"}}) {
            const studies::SingleCell cell = framed_cell(scene, table, algorithm);
            const std::size_t count = cell.workload().queries.size();
            const double expected = cell.runner().prepared_range()(0, count, nullptr);
            const auto frames = cell.runner().prepared_frames();
            ASSERT_TRUE(frames);
            for (const int threads : {1, 2, 4}) {
                frames->set_back();
                frames->run(threads);
                EXPECT_EQ(frames->sum(), expected) << scene.kind << ' ' << table << ' ' << threads;
            }
            EXPECT_GT(expected, 0);
            EXPECT_EQ(frames->frames() == 1, scene.is_one_frame) << frames->frames();
            if (scene.is_one_frame) continue;
            // Pairs go on where they were: other starts, so other last bits here and there.
            frames->run(2);
            std::printf("%s %s: %zu frames, sum %.17g, of pairs that go on %.17g\n", scene.kind, table,
                        frames->frames(), expected, frames->sum());
        }
    }
}

TEST(FrameBatches, AskNoPairTwiceInAFrameAndEachInItsOrder) {
    for (const FramedScene& scene : framed_scenes) {
        const studies::SingleCell cell = framed_cell(scene, "lean_f64", "gjk");
        const scene::Workload& workload = cell.workload();
        std::vector<std::size_t> last(workload.pair_count, 0);
        std::set<std::size_t> asked;
        for (const auto& frame : frames_of(workload)) {
            std::set<std::uint32_t> pairs;
            for (const std::size_t i : frame) {
                EXPECT_TRUE(asked.insert(i).second);
                if (!workload.warm) continue;
                const std::uint32_t pair = workload.queries[i].pair;
                EXPECT_TRUE(pairs.insert(pair).second);
                EXPECT_GE(i + 1, last[pair]) << "in time order";
                last[pair] = i + 1;
            }
        }
        EXPECT_EQ(asked.size(), workload.queries.size());
    }
}

}  // namespace
}  // namespace edgewise::bench
